"""A callback that any thread can ask the executor to run."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.callback_group import CallbackGroup
    from zbot.mailbox import Mailbox


class GuardCondition:
    """Runs its callback in the executor, once for any number of triggers since the last run.

    Args:
        callback: Called without arguments; may be a coroutine function.
        callback_group: Decides beside what it may run.
        mailbox: The node's way to its executor.
    """

    due_ns: int | None = None

    def __init__(
        self, callback: Callable[[], Any] | None, callback_group: CallbackGroup, mailbox: Mailbox
    ) -> None:
        self.callback = callback
        self.callback_group = callback_group
        self.mailbox = mailbox
        self._triggered = False

    def trigger(self) -> None:
        """Ask for the callback to be run; from any thread."""
        self._triggered = True
        self.mailbox.post(self)

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
