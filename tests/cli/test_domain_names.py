from __future__ import annotations

import os
from typing import TYPE_CHECKING

import pytest

from zbot.transport import membership
from zbot.transport.membership import Membership
from zbot_cli.errors import CommandError
from zbot_cli.input.domain_names import as_typed, did_you_mean, select_domain, where_to_look

if TYPE_CHECKING:
    from tests.cli.conftest import Command


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


def test_messages_show_a_name_as_it_was_typed() -> None:
    assert as_typed("/scan") == "/scan"
    assert where_to_look("topic") == "`zbot topic list` shows the topics"
    select_domain(["topic", "echo", "/17/scn"])
    assert as_typed("/scn") == "/17/scn"
    assert did_you_mean("/scn", ["/scan", "/odom"]) == "did you mean '/17/scan'?"
    assert did_you_mean("/x", ["/y"]) == ""
    assert where_to_look("topic") == "`zbot topic list /17` shows the topics"


def test_a_student_learns_who_can_show_the_names_of_another(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    student = Membership("student", "127.0.0.1", 7447, "robots", 18, "Cem")
    monkeypatch.setattr(membership, "load", lambda: student)
    select_domain(["topic", "echo", "/17/scan"])
    assert where_to_look("topic") == (
        "this laptop has number 18, and sees the names of number 17 only after the teacher typed: "
        "zbot share 17 18"
    )
    select_domain(["topic", "echo", "/18/scan"])
    assert where_to_look("topic") == "`zbot topic list /18` shows the topics"


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ("topic info {}/scan", "Unknown topic '{}/scan'"),
        ("node info {}/talker", "Unable to find node '{}/talker'"),
        ("param list {}/talker --timeout 0.1", "no node {}/talker is running"),
        ("topic echo {}/scan --timeout 0.1", "no message on {}/scan within 0.1 s"),
    ],
)
def test_a_missing_name_is_shown_as_it_was_typed(
    zbot_command: Command, domain: int, words: str, sentence: str
) -> None:
    refused = zbot_command(*words.format(f"/{domain}").split())
    assert refused.code == 1
    assert sentence.format(f"/{domain}") in refused.err
