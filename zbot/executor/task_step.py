"""Step of a task, as an entity that an executor queues and runs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.executor.callback_group import ReentrantCallbackGroup

if TYPE_CHECKING:
    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.task import Task

_ALWAYS = ReentrantCallbackGroup()


class TaskStep:
    """The next step of a task. It runs once. The task schedules a new object for each step."""

    __slots__ = ("_is_taken", "callback_group", "task")
    due_ns: int | None = None
    ready_queue = None

    def __init__(self, task: Task[Any]) -> None:
        self.task = task
        self.callback_group: CallbackGroup = _ALWAYS
        self._is_taken = False

    def take(self) -> object | None:
        """Return this object once. Return `None` at later calls, and if the task is over."""
        if self._is_taken or self.task.is_over:
            return None
        self._is_taken = True
        return self

    def execute(self, taken: object) -> None:  # noqa: ARG002 - every entity's signature
        """Run the step, and raise the exception that the task raised."""
        self.task()
        if self.task.done():
            self.task.result()  # an exception ends spin(), as in rclpy
