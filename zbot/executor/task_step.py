"""What an executor does for a task: one step after the other, each a piece of work in its queue."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.executor.callback_group import ReentrantCallbackGroup

if TYPE_CHECKING:
    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.task import Task

_ALWAYS = ReentrantCallbackGroup()


class TaskStep:
    """A task's next step, as work in the queue: once, for the one after it is scheduled anew."""

    __slots__ = ("_is_taken", "callback_group", "task")
    due_ns: int | None = None
    ready_queue = None

    def __init__(self, task: Task[Any]) -> None:
        self.task = task
        self.callback_group: CallbackGroup = _ALWAYS
        self._is_taken = False

    def take(self) -> object | None:
        """Return itself, once."""
        if self._is_taken or self.task.is_over:
            return None
        self._is_taken = True
        return self

    def execute(self, taken: object) -> None:  # noqa: ARG002 - every entity's signature
        """Run the step; what the task raised is raised here, too."""
        self.task()
        if self.task.done():
            self.task.result()  # what it raised ends spin(), as in rclpy
