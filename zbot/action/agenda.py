"""Work of an action that the node's executor does: calling the user, one piece after the other."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.ready_queue import Mailbox


class Agenda:
    """Functions that wait for the executor, which may come later than they do.

    Args:
        mailbox: The node's way to its executor.
        callback_group: Decides beside what a function may run.
    """

    due_ns: int | None = None

    def __init__(self, mailbox: Mailbox, callback_group: CallbackGroup) -> None:
        self.mailbox = mailbox
        self.callback_group = callback_group
        self._functions: deque[Callable[[], Any]] = deque()
        mailbox.add(self)

    def add(self, function: Callable[[], Any]) -> None:
        """Let the executor call a function or coroutine function; from any thread."""
        self._functions.append(function)
        self.mailbox.post(self)

    def take(self) -> Callable[[], Any] | None:
        """Return the function whose turn it is, if any."""
        try:
            return self._functions.popleft()
        except IndexError:
            return None

    def execute(self, function: Callable[[], Any]) -> Any:
        """Call it; a coroutine is the executor's to run."""
        return function()

    def destroy(self) -> None:
        """Forget what waits."""
        self.mailbox.remove(self)
        self._functions.clear()
