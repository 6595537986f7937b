"""Tests of the sentences of `zbot class` that need no class."""

from __future__ import annotations

import pytest

from zbot.classroom.teacher import opening
from zbot.classroom.teacher.invitation import Invitation
from zbot_cli.commands.class_ import _join_text, check
from zbot_cli.errors import CommandError


def text(code: str | None, port: int) -> str:
    return _join_text(Invitation("Robots", code, code, "10.0.0.2", port, "402917", None))


def test_a_class_with_a_code_shows_the_code_and_the_address() -> None:
    assert "\n    zbot join K7QX\n    zbot join 10.0.0.2:7447    (if the code" in text("K7QX", 7447)
    assert "There is no code" not in text("K7QX", 7447)


def test_a_class_without_a_code_says_why_and_shows_the_address() -> None:
    shown = text(None, 7999)
    assert "no code can contain the port 7999: use the default port, or a port from 7440" in shown
    assert "\n    zbot join 10.0.0.2:7999\n\nPIN: 402917\n" in shown


@pytest.mark.parametrize("as_json", [False, True])
def test_a_check_of_nobody_is_an_error(monkeypatch: pytest.MonkeyPatch, as_json: bool) -> None:
    monkeypatch.setattr(opening, "check_class", lambda _: [])
    with pytest.raises(CommandError, match="nobody has joined the class") as caught:
        check("publishes std_msgs/String on /chatter", as_json=as_json)
    assert "zbot class list" in caught.value.hint
