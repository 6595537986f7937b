"""Tests of the wait for a reply in `Client.call`."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

from tests.unit.node.fakes import TIMEOUT, Sender, reply
from zbot.errors import NotInitializedError
from zbot.node.blocking_call import wait_for_reply
from zbot.node.service_request import ServiceRequest
from zbot.threads.wakeup import BusyWait

if TYPE_CHECKING:
    from collections.abc import Callable

ANSWER = reply(b"answer")


class Caller(Sender):
    """Client whose server gives the replies of each attempt at once."""

    service_name = "/add"

    def __init__(self, *replies: list[Any]) -> None:
        super().__init__()
        self._replies = iter(replies)
        self.wakers: list[Callable[[], None]] = []
        self.busy_wait = BusyWait()
        self.context: Any = SimpleNamespace(
            add_waker=self.wakers.append, remove_waker=self.wakers.remove, is_over=False
        )

    def send(self, request: Any, on_reply: Any, on_end: Any) -> None:
        self(request, on_reply, on_end)
        replies = next(self._replies, None)
        if replies is not None:
            self.answer(*replies)


def wait(caller: Caller, timeout_sec: float | None = None) -> Any:
    return wait_for_reply(caller, ServiceRequest(b"", bytes(33)), timeout_sec)


def test_the_reply_is_returned() -> None:
    caller = Caller([ANSWER])
    assert wait(caller) is ANSWER
    assert caller.wakers == []


def test_there_is_no_reply_if_the_server_ended() -> None:
    assert wait(Caller([])) is None


def test_an_attempt_that_timed_out_is_repeated_with_a_longer_timeout() -> None:
    caller = Caller([TIMEOUT, TIMEOUT], [TIMEOUT], [ANSWER])
    assert wait(caller) is ANSWER
    assert caller.timeouts_s == [2, 4, 8]


@pytest.mark.parametrize("timeout_sec", [0.001, 0, -1])
def test_a_call_without_a_response_in_time_raises(timeout_sec: float) -> None:
    caller = Caller()
    with pytest.raises(TimeoutError, match="/add: there was no response in time"):
        wait(caller, timeout_sec)
    assert caller.wakers == []


def test_a_shutdown_ends_the_wait() -> None:
    class ShutDown(Caller):
        def send(self, request: Any, on_reply: Any, on_end: Any) -> None:
            super().send(request, on_reply, on_end)
            self.context.is_over = True
            self.wakers[0]()

    with pytest.raises(NotInitializedError):
        wait(ShutDown())
