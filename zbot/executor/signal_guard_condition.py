"""Guard condition that a signal triggers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.context import get_default_context
from zbot.errors import InvalidHandleError, NotInitializedError
from zbot.executor.guard_condition import GuardCondition
from zbot.process import signals

if TYPE_CHECKING:
    from zbot.context import Context


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
