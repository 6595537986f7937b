"""A callback that any thread can ask the executor to run."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.executor.callback_group import ReentrantCallbackGroup
from zbot.executor.ready_queue import ReadyQueue
from zbot.transport.handle import Handle

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.callback_group import CallbackGroup


class GuardCondition:
    """Runs its callback in the executor, once for any number of triggers since the last run.

    Args:
        callback: Called without arguments; may be a coroutine function.
        callback_group: Decides beside what it may run.
        context: Accepted: rclpy's guard conditions belong to one.
        ready_queue: The node's way to its executor; one that only a `WaitSet` looks at has none.
    """

    due_ns: int | None = None

    def __init__(
        self,
        callback: Callable[[], Any] | None = None,
        callback_group: CallbackGroup | None = None,
        context: object = None,  # noqa: ARG002 - rclpy's signature
        *,
        ready_queue: ReadyQueue | None = None,
    ) -> None:
        self.callback = callback
        self.callback_group = callback_group or ReentrantCallbackGroup()
        self.ready_queue = ready_queue or ReadyQueue()
        self._triggered = False

    @property
    def handle(self) -> GuardConditionHandle:
        """What a `WaitSet` takes."""
        return GuardConditionHandle(self)

    @property
    def has_work(self) -> bool:
        """Whether it was triggered since the last time."""
        return self._triggered

    def trigger(self) -> None:
        """Ask for the callback to be run; from any thread."""
        self._triggered = True
        self.ready_queue.post(self)

    def take(self) -> object | None:
        """Return something if it was triggered since the last time."""
        if not self._triggered:
            return None
        self._triggered = False
        return self

    def execute(self, taken: object) -> Any:  # noqa: ARG002 - every entity's signature
        """Run the callback."""
        return self.callback() if self.callback is not None else None

    def destroy(self) -> None:
        """Never run the callback again."""
        self.callback = None


class GuardConditionHandle(Handle[GuardCondition]):
    """A guard condition's handle."""

    def trigger_guard_condition(self) -> None:
        """Do what `GuardCondition.trigger` does."""
        self.entity.trigger()
