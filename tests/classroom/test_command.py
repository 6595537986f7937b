"""Teacher's commands to a hub that does not answer."""

from __future__ import annotations

from contextlib import nullcontext
from typing import TYPE_CHECKING, Any

import pytest

from zbot.classroom.errors import ClassCommandError
from zbot.classroom.teacher import opening

if TYPE_CHECKING:
    from collections.abc import Callable

    Say = Callable[..., None]


@pytest.fixture
def say(monkeypatch: pytest.MonkeyPatch) -> Say:
    """Return a function that decides what the hub answers, one question after the other."""
    monkeypatch.setattr(opening, "_client", nullcontext)

    def decide(*told: list[dict[str, Any]]) -> None:
        answers = iter(told)
        monkeypatch.setattr(opening, "ask", lambda *_, **__: next(answers))

    return decide


def test_a_hub_that_is_opened_anew_is_asked_again(say: Say) -> None:
    say([], [], [{"open": True}])
    assert opening.command({"op": "open"}) == {"open": True}


def test_a_hub_that_does_not_answer_is_reported(say: Say, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(opening, "_REOPENING_S", -1.0)
    say([])
    with pytest.raises(ClassCommandError, match="does not answer"):
        opening.command({"op": "open"})
