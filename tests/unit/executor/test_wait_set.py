from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.executor.ready_queue import ReadyQueue
from zbot.executor.wait_set import WaitSet
from zbot.threads.handle import Handle

if TYPE_CHECKING:
    from collections.abc import Iterator


class LateTimer:
    """Timer that is due for a long time, and ready only when it is asked for the third time."""

    due_ns = 0

    def __init__(self) -> None:
        self.ready_queue = ReadyQueue()
        self._looks: Iterator[bool] = iter([False, False, True])

    @property
    def has_work(self) -> bool:
        return next(self._looks)


def test_a_timer_may_become_due_during_a_wait() -> None:
    timer: Any = LateTimer()
    waiting = WaitSet()
    index = waiting.add_timer(Handle(timer))
    waiting.wait(-1)
    assert waiting.is_ready("timer", index)
