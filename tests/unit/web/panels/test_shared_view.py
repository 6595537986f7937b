"""Tests of the process of the 3D view, which all browsers share."""

from __future__ import annotations

import threading

import pytest

from tests.conftest import wait_until
from zbot.observer.errors import ViewerError
from zbot.web.panels.view import shared_view
from zbot.web.panels.view.shared_view import SharedView


class Process:
    """Process that "serves" until it is closed."""

    def __init__(self) -> None:
        self.is_running = True

    def address(self) -> tuple[int, str]:
        return 8090, "token"

    def close(self) -> None:
        self.is_running = False


@pytest.fixture(autouse=True)
def extra(monkeypatch: pytest.MonkeyPatch) -> None:
    """Make tests independent of the extra `view`."""
    monkeypatch.setattr(shared_view, "check_extra", lambda: None)


def started() -> tuple[SharedView, list[Process]]:
    processes: list[Process] = []

    def start() -> Process:
        processes.append(Process())
        return processes[-1]

    return SharedView(start, linger_s=0.01), processes


def test_all_panels_share_one_process_that_ends_after_the_last() -> None:
    view, processes = started()
    view.open()
    view.open()
    assert view.address() == view.address() == (8090, "token")
    assert len(processes) == 1
    view.release()
    assert processes[0].is_running
    view.release()
    assert wait_until(lambda: not processes[0].is_running)
    assert not view.has_ended  # it has not ended by itself


def test_a_process_that_has_ended_is_started_again() -> None:
    view, processes = started()
    view.open()
    view.address()
    processes[0].is_running = False
    assert view.has_ended
    view.address()
    assert len(processes) == 2
    view.close()
    assert not processes[1].is_running


def test_opening_a_panel_does_not_wait_for_a_start() -> None:
    is_over = threading.Event()

    class Slow(Process):
        def address(self) -> tuple[int, str]:
            is_over.wait(5)
            return super().address()

    view = SharedView(Slow)
    thread = threading.Thread(target=view.address)
    thread.start()
    view.open()
    view.release()
    assert thread.is_alive()
    is_over.set()
    thread.join()
    view.close()


def test_without_the_extra_nothing_starts(monkeypatch: pytest.MonkeyPatch) -> None:
    def check() -> None:
        raise ViewerError("the view needs viser")

    monkeypatch.setattr(shared_view, "check_extra", check)
    view, processes = started()
    view.open()
    with pytest.raises(ViewerError, match="needs viser"):
        view.address()
    view.release()
    assert not processes
