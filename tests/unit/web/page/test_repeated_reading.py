"""Tests of slow readings that a page repeats."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

import pytest

pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')

from zbot.web.page.repeated_reading import RepeatedReading

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine


class Label:
    """Label of the page."""

    def __init__(self) -> None:
        self.text, self.is_visible = "", True

    def classes(self, _names: str) -> Label:
        return self

    def set_text(self, text: str) -> None:
        self.text = text

    def set_visibility(self, is_visible: bool) -> None:
        self.is_visible = is_visible


class Section:
    """Section whose updates the test calls."""

    def live(self, update: Callable[[], None], _max_hz: float) -> None:
        self.update = update


def test_a_problem_is_shown_until_the_next_good_reading(monkeypatch: pytest.MonkeyPatch) -> None:
    label, results, runs = Label(), ["one"], list[Any]()

    def create(run: Coroutine[Any, Any, None], **_: object) -> None:
        runs.append(run)

    monkeypatch.setattr("nicegui.ui.label", lambda: label)
    monkeypatch.setattr("nicegui.background_tasks.create", create)
    section: Any = Section()
    reading = RepeatedReading(section, results.pop, "", max_hz=1.0)

    def read() -> tuple[str, str, bool]:
        section.update()
        asyncio.run(runs.pop())
        return reading.value, label.text, label.is_visible

    assert read() == ("one", "", False)
    assert read() == ("one", "pop from empty list", True)
    assert read() == ("one", "pop from empty list", True)
    results.append("two")
    assert read() == ("two", "", False)
