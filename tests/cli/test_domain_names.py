from __future__ import annotations

import os

import pytest

from zbot_cli.errors import CommandError
from zbot_cli.input.domain_names import select_domain


@pytest.fixture(autouse=True)
def no_domain(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ZBOT_COMMAND_DOMAIN", "")  # restored afterwards


@pytest.mark.parametrize(
    ("words", "kept"),
    [
        ("topic echo /17/temperature", "topic echo /temperature"),
        ("topic echo /17/a/b --once", "topic echo /a/b --once"),
        ("topic hz /17/a /17/b", "topic hz /a /b"),
        ("topic list /17", "topic list"),
        ("topic list -t /17/", "topic list -t /"),
        ("graph /17 --dot", "graph --dot"),
        ("param set /17/node path /18/file", "param set /node path /18/file"),
        ("topic pub /17/a std_msgs/String /17/b", "topic pub /a std_msgs/String /17/b"),
    ],
)
def test_a_name_may_begin_with_the_number_of_a_domain(words: str, kept: str) -> None:
    assert select_domain(words.split()) == kept.split()
    assert os.environ["ZBOT_COMMAND_DOMAIN"] == "17"


@pytest.mark.parametrize("words", ["topic echo /scan", "topic echo /robot17/scan", "topic list"])
def test_names_in_the_own_domain_are_unchanged(words: str) -> None:
    assert select_domain(words.split()) == words.split()
    assert not os.environ["ZBOT_COMMAND_DOMAIN"]


def test_a_command_refuses_names_of_two_domains() -> None:
    with pytest.raises(CommandError, match="not in /17 and /18"):
        select_domain(["topic", "echo", "/17/a", "/18/a"])
