"""The view goes on after a wish of its user that fails, and says why."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

from zbot.observer.errors import ViewerError
from zbot.view import view as view_module
from zbot.view.panel import Wish
from zbot.view.view import View

if TYPE_CHECKING:
    from zbot.log.record import Record


class FakePanel:
    """Panel that keeps what it must say."""

    def __init__(self) -> None:
        self.notes: list[str] = []

    def note(self, sentence: str) -> None:
        self.notes.append(sentence)

    def say(self, _sentence: str, *, is_warning: bool) -> None: ...


def fail(error: Exception) -> Any:
    def function(*_arguments: Any) -> Any:
        raise error

    return function


@pytest.fixture
def panel() -> FakePanel:
    return FakePanel()


@pytest.fixture
def frames() -> SimpleNamespace:
    return SimpleNamespace(fixed="map", choose=fail(KeyError("defect")))


@pytest.fixture
def view(panel: FakePanel, frames: SimpleNamespace) -> View:
    system: Any = SimpleNamespace(revision=-1)
    drawing: Any = SimpleNamespace(camera=None, look_from=fail(ViewerError("no browser")))
    clock: Any = SimpleNamespace(has_jumped_back=lambda: False)
    given: Any = panel
    outlet: Any = None
    some_frames: Any = frames
    made = View(system, some_frames, drawing, lambda _: given, clock=clock, outlet=outlet)
    made._is_paused = True  # it draws nothing
    return made


def test_a_wish_that_fails_is_a_sentence_and_the_next_is_carried_out(
    view: View, panel: FakePanel, logged: list[Record]
) -> None:
    view._ask(Wish.FIXED_FRAME, "map")
    view._ask(Wish.VIEW, "above")
    view.open_link("no arrangement")
    view.tick()
    first, second, third = panel.notes
    assert first == "The view could not do this: KeyError('defect')"
    assert second == "no browser"
    assert "arrangement" in third
    (line,) = (record.message for record in logged)
    assert "Traceback" in line


def test_a_file_that_cannot_be_written_is_an_error_of_its_reader(
    view: View, monkeypatch: pytest.MonkeyPatch, logged: list[Record]
) -> None:
    monkeypatch.setattr(view_module, "rviz_text", fail(KeyError("defect")))
    asked = view.rviz_file()
    view.tick()
    assert isinstance(asked.exception(timeout=0), KeyError)
    assert len(logged) == 1
