"""Tests of the command line of `zbot mqtt`, without a broker."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from tests.cli.conftest import Command


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ((), "there is nothing to do"),
        (("http://a", "--from", "#"), "'http://a' is not the address of a broker"),
        (("--from", "#", "--type", "a:Flaot32"), "there is no type std_msgs/msg/Flaot32"),
        (("--to", "/a*=b"), "only the name of one topic can have a name after '='"),
        (("--from", "#", "--ca", "no.pem"), "cannot read the certificates"),
    ],
)
def test_wrong_words_are_one_sentence(
    zbot_command: Command, words: tuple[str, ...], told: str
) -> None:
    result = zbot_command("mqtt", *words)
    assert (result.code, result.out) == (1, "")
    assert told in result.err
