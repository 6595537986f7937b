"""Guard conditions, which a program or a signal triggers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.context import get_default_context
from zbot.errors import InvalidHandleError, NotInitializedError
from zbot.executor.callback_group import ReentrantCallbackGroup
from zbot.executor.ready_queue import ReadyQueue
from zbot.process import signals
from zbot.threads.handle import Handle

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.context import Context
    from zbot.executor.callback_group import CallbackGroup


class GuardCondition:
    """Runs its callback in the executor after one or more triggers.

    If it is triggered several times before the callback runs, the callback runs once.

    Args:
        callback: Called without arguments. It may be a coroutine function.
        callback_group: Decides which callbacks may run at the same time.
        context: Accepted and not used. rclpy's guard conditions belong to a context.
        ready_queue: The node's ready queue. If left out, only a `WaitSet` can use the guard
            condition.
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
        """The handle that a `WaitSet` takes."""
        return GuardConditionHandle(self)

    @property
    def has_work(self) -> bool:
        """Whether the guard condition was triggered since the last `take`."""
        return self._triggered

    def trigger(self) -> None:
        """Ask the executor to run the callback. Any thread may call this."""
        self._triggered = True
        self.ready_queue.post(self)

    def take(self) -> object | None:
        """Return the guard condition if it was triggered since the last call, else `None`."""
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


class SignalHandlerGuardCondition(GuardCondition):
    """Guard condition that Ctrl-C and SIGTERM trigger. So they wake a `WaitSet` that waits for it.

    Args:
        context: A context that is initialised and not shut down. If left out, the default context
            is used.

    Raises:
        NotInitializedError: The context is not initialised, or it was shut down.
    """

    def __init__(self, context: Context | None = None) -> None:
        if not (context or get_default_context()).is_running:
            raise NotInitializedError("a guard condition")
        super().__init__()
        signals.guard_conditions.add(self)

    def destroy(self) -> None:
        """Stop reacting to signals.

        Raises:
            InvalidHandleError: The guard condition was destroyed before.
        """
        if self not in signals.guard_conditions:
            raise InvalidHandleError("the guard condition")
        signals.guard_conditions.discard(self)
        super().destroy()
