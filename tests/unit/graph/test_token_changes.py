"""Tests of the changes of liveliness tokens, in the order in which Zenoh received them."""

from __future__ import annotations

import threading
from collections import deque
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest
import zenoh

from zbot.graph import token_changes as module
from zbot.graph.token_changes import TokenChanges

if TYPE_CHECKING:
    from collections.abc import Callable


@pytest.fixture(autouse=True)
def no_pauses(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_LATE_S", tuple(0.0 for _ in module._LATE_S))


class Session:
    """Zenoh session whose subscribers get changes from the test."""

    def __init__(self) -> None:
        self.queue: deque[str] = deque()
        self.tell: Any = None
        self.closed = False
        self.undeclared = 0

    def liveliness(self) -> Any:
        return SimpleNamespace(declare_subscriber=self._declare)

    def is_closed(self) -> bool:
        return self.closed

    def _declare(self, key: str, handler: Any, *, history: bool) -> Any:
        assert (key, history) == ("a/**", True)
        if callable(handler):
            self.tell = handler
        return SimpleNamespace(
            handler=SimpleNamespace(try_recv=self._try_recv), undeclare=self._undeclare
        )

    def _undeclare(self) -> None:
        self.undeclared += 1

    def _try_recv(self) -> str | None:
        if self.closed:
            raise zenoh.ZError("the session is closed")
        return self.queue.popleft() if self.queue else None


def changes_of(session: Any, seen: list[Any]) -> TokenChanges:
    def start(name: str, run: Callable[[], None], _end: Callable[[], object]) -> None:
        assert name == "zbot graph"
        run()  # in this thread

    return TokenChanges(session, seen.append, lambda function: function, start)


def test_changes_are_used_in_their_order() -> None:
    session, seen = Session(), list[Any]()
    session.queue.extend(["+a", "+b"])
    changes_of(session, seen).follow("a/**")
    assert seen == ["+a", "+b"]
    session.queue.extend(["-a", "+a", "-b"])
    session.tell("-a")
    assert seen == ["+a", "+b", "-a", "+a", "-b"]


@pytest.mark.parametrize("comes_at", [2, 3, 4])
def test_a_change_that_comes_after_its_call_is_found(comes_at: int) -> None:
    session, seen = Session(), list[Any]()
    changes = changes_of(session, seen)
    changes.follow("a/**")
    looks = 0
    try_recv = session._try_recv

    def late() -> str | None:
        nonlocal looks
        looks += 1
        if looks == comes_at:
            session.queue.append("+late")
        return try_recv()

    for subscriber in changes._subscribers:
        subscriber.handler.try_recv = late
    session.tell("+late")
    assert seen == ["+late"]


def test_the_end_of_the_session_ends_the_work() -> None:
    session, seen = Session(), list[Any]()
    changes_of(session, seen).follow("a/**")
    session.closed = True
    session.tell("-a")
    assert seen == []


def test_the_end_does_not_wait_for_the_last_look(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_LATE_S", (600.0,))
    session = Session()
    threads: list[tuple[threading.Thread, Callable[[], object]]] = []

    def start(name: str, run: Callable[[], None], end: Callable[[], object]) -> None:
        threads.append((threading.Thread(target=run, name=name), end))
        threads[-1][0].start()

    made: Any = session
    TokenChanges(made, print, lambda function: function, start).follow("a/**")
    ((thread, end),) = threads
    session.closed = True
    end()
    thread.join(30)
    assert not thread.is_alive()


def test_who_has_a_message_knows_the_token_of_its_sender() -> None:
    session, seen = Session(), list[Any]()
    changes = changes_of(session, seen)
    changes.follow("a/**")
    session.queue.append("+sender")  # and Zenoh has not called the function yet
    changes.catch_up()
    assert seen == ["+sender"]


def test_after_the_end_no_token_is_followed() -> None:
    session, seen = Session(), list[Any]()
    changes = changes_of(session, seen)
    changes.follow("a/**")
    changes.close()
    assert session.undeclared == 2
    session.queue.append("+a")
    changes.catch_up()
    assert seen == []
