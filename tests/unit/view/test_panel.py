"""Tests of the panel beside the scene: what a user chooses is what the view is asked for."""

from __future__ import annotations

import asyncio
import inspect
from contextlib import nullcontext
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

from zbot.view.panel import Panel, Wish

if TYPE_CHECKING:
    from collections.abc import Callable


class Element:
    """Element that calls its listeners as viser does: coroutines at once, functions later."""

    def __init__(self, value: Any, later: list[Callable[[], object]]) -> None:
        self.value, self._later = value, later
        self._listeners: list[Any] = []
        self.on_update = self.on_click = self._listeners.append
        self.max = 100.0

    def choose(self, value: Any) -> None:
        """Do what viser does when a browser sends a value."""
        self.value = value
        event = SimpleNamespace(client="a browser", target=self)
        for listener in self._listeners:
            if inspect.iscoroutinefunction(listener):
                asyncio.run(listener(event))
            else:
                self._later.append(lambda listener=listener: listener(event))  # type: ignore[misc]


class Gui:
    """The elements of viser's panel, by their labels."""

    def __init__(self) -> None:
        self.elements: dict[str, Element] = {}
        self.later: list[Callable[[], object]] = []

    def _add(self, label: str, value: Any) -> Element:
        self.elements[label] = Element(value, self.later)
        return self.elements[label]

    def add_checkbox(self, label: str, value: bool) -> Element:
        return self._add(label, value)

    def add_slider(self, label: str, *limits: float) -> Element:
        return self._add(label, limits[-1])

    def add_dropdown(self, label: str, _options: Any, *, initial_value: str, **_: Any) -> Element:
        return self._add(label, initial_value)

    def add_folder(self, *_: Any, **__: Any) -> Any:
        return nullcontext()

    def __getattr__(self, name: str) -> Any:
        return lambda label="", *_, **__: self._add(f"{name} {label}", None)


@pytest.mark.parametrize(
    ("label", "chosen", "wish"),
    [("Time in s", 100.0, Wish.SEEK), ("Play", False, Wish.PLAY)],
)
def test_a_choice_is_not_lost_if_the_view_shows_the_time_then(
    label: str, chosen: Any, wish: Wish
) -> None:
    gui, wishes = Gui(), list[tuple[Wish, Any]]()
    panel = Panel(gui, "View", lambda *words: wishes.append(words))
    panel.add_timeline(100.0)
    gui.elements[label].choose(chosen)
    panel.show_time(3.0, is_playing=True)  # what the view knew before it heard of the choice
    for call in gui.later:
        call()
    assert wishes == [(wish, chosen)]
