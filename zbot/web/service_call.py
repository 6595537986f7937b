"""Calling services for a page, and telling its user what went wrong."""

from __future__ import annotations

import asyncio
import functools
from typing import TYPE_CHECKING, Any, TypeVar

from nicegui import run, ui

from zbot.errors import ZbotError
from zbot.web.system import answer

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine

    from zbot.web.system import System

T = TypeVar("T")

#: Seconds.
PATIENCE_S = 10.0


class NoAnswerError(ZbotError, TimeoutError):
    """A service did not answer in time."""

    def __init__(self, name: str, timeout_s: float) -> None:
        self.name, self.timeout_s = name, timeout_s
        super().__init__(f"{name} did not answer within {timeout_s:g} s: its node is busy or stuck")


async def call(
    system: System,
    name: str,
    type_name: str,
    request: Any,
    *,
    changes: bool = True,
    timeout_s: float = PATIENCE_S,
) -> Any:
    """Call a service from NiceGUI's loop and return the response.

    Args:
        system: The running system.
        name: The service's full name.
        type_name: Its type.
        request: The request, or what makes it, given the service's class.
        changes: Whether a page that may only look has to refuse.
        timeout_s: The longest wait.

    Raises:
        ReadOnlyError: The page may only look.
        NoAnswerError: The server did not answer in time.
        ServiceError: There is no server, its callback raised, or it ended.
        NoTypeError: Nobody knows the type.
    """
    connect = system.client if changes else system.reader
    # The type may have to be asked of another machine, which takes its time.
    lease = await in_thread(connect, name, type_name)
    with lease:
        try:
            return await answer(lease.entity.call_async(request), timeout_s)
        except asyncio.TimeoutError:
            raise NoAnswerError(name, timeout_s) from None


async def in_thread(function: Callable[..., T], *arguments: Any) -> T:
    """Run a function that may take a while, while NiceGUI's loop goes on."""
    made = await run.io_bound(function, *arguments)
    if made is None:
        raise asyncio.CancelledError  # the server is about to end
    return made


def complain(error: Exception) -> None:
    """Show an error's sentence in the page."""
    ui.notify(str(error), type="negative", multi_line=True, classes="zb-complaint")


def guarded(
    action: Callable[..., Coroutine[Any, Any, None]],
) -> Callable[..., Coroutine[Any, Any, None]]:
    """Return a handler that tells its user of errors, which are sentences, in the page."""

    @functools.wraps(action)  # NiceGUI looks at what a handler takes
    async def handler(*arguments: Any) -> None:
        try:
            await action(*arguments)
        except ZbotError as error:
            complain(error)

    return handler
