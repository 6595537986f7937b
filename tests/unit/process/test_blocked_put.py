"""Tests of puts that wait for a subscription that reads nothing, and of their cancellation."""

from __future__ import annotations

from collections import deque
from types import SimpleNamespace
from typing import Any

import pytest
import zenoh

from zbot.process import blocked_put
from zbot.threads.weak_set import WeakSet


class Publisher:
    """Publisher whose put ends when the links are cut."""

    def __init__(self, *, is_putting: bool = True) -> None:
        self.is_putting = is_putting
        self.sent_count = 1


@pytest.fixture
def cut(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """Return a list of the sessions whose links are cut, which lets all puts return."""
    sessions = list[Any]()

    def cut_links(session: Any) -> None:
        sessions.append(session)
        for publisher in blocked_put.publishers:
            publisher.is_putting = False

    monkeypatch.setattr(blocked_put, "publishers", WeakSet[Any]())
    monkeypatch.setattr(blocked_put, "local_queues", WeakSet[Any]())
    monkeypatch.setattr(blocked_put, "_BLOCKED_AFTER_S", 0.02)
    monkeypatch.setattr(blocked_put, "_cut", cut_links)
    return sessions


def cancel(*sessions: Any) -> None:
    blocked_put.cancel_all(sessions)


def test_links_stay_if_no_put_runs(cut: list[Any]) -> None:
    idle = Publisher(is_putting=False)
    blocked_put.publishers.add(idle)
    cancel("session")
    assert cut == []


def test_a_blocked_put_cuts_the_links_of_the_sessions(cut: list[Any]) -> None:
    blocked = Publisher()
    blocked_put.publishers.add(blocked)
    cancel("first", "second")
    assert cut == ["first", "second"]
    assert not blocked.is_putting


def test_puts_that_go_on_are_not_blocked(cut: list[Any]) -> None:
    class Busy(Publisher):
        """Publisher that sends the next message whenever it is looked at."""

        def __getattribute__(self, name: str) -> Any:
            if name == "sent_count":
                self.sent_count = super().__getattribute__(name) + 1
            return super().__getattribute__(name)

    busy = Busy()
    blocked_put.publishers.add(busy)
    cancel("session")
    assert cut == []


def test_full_queues_of_this_process_are_emptied(cut: list[Any]) -> None:
    class Queue:
        def __init__(self, *samples: str) -> None:
            self.samples = deque(samples)

        def next_sample(self) -> str | None:
            return self.samples.popleft() if self.samples else None

    class Gone(Queue):
        def next_sample(self) -> str | None:
            raise zenoh.ZError("undeclared")

    blocked, queues = Publisher(), [Gone(), Queue("a", "b"), Gone(), Queue("c")]
    blocked_put.publishers.add(blocked)
    for queue in queues:
        blocked_put.local_queues.add(queue)
    cancel("session")
    assert [len(queue.samples) for queue in queues] == [0, 0, 0, 0]
    assert cut == ["session"]


def test_a_closed_session_has_no_links_to_cut() -> None:
    def links() -> Any:
        raise zenoh.ZError("closed")

    session: Any = SimpleNamespace(info=SimpleNamespace(links=links))
    blocked_put._cut(session)
