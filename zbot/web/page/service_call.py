"""Service calls of a page, and the display of their errors."""

from __future__ import annotations

import asyncio
import functools
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any, TypeVar

from nicegui import ui

from zbot.errors import ZbotError
from zbot.observer.system import PATIENCE_S
from zbot.remote.service_calls import NoAnswerError

if TYPE_CHECKING:
    from collections.abc import Awaitable, Callable, Coroutine

    from zbot.observer.system import System

T = TypeVar("T")

#: Threads for functions that wait for other nodes, some of which never answer. They have many
#: threads, because such a function may wait 10 s.
WAITING = ThreadPoolExecutor(64, "zbot web waits")
#: Threads for functions that need the processor. With more threads, NiceGUI's loop gets its turn
#: less often.
READING = ThreadPoolExecutor(4, "zbot web reads")
#: Threads for functions that read whole bags, which takes minutes.
EXPORTING = ThreadPoolExecutor(2, "zbot web exports")
#: Thread for drawings of the graph. All pages draw it again at each change.
DRAWING = ThreadPoolExecutor(1, "zbot web draws")


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
        type_name: The full name of the service's type.
        request: The request.
        changes: Whether the call changes something. If so, a read-only page refuses the call.
        timeout_s: The longest wait, in seconds.

    Raises:
        ViewerError: The page is read-only, and `changes` is true.
        NoAnswerError: The server did not answer in time.
        ServiceError: There is no server, its callback raised an error, or the server ended.
        UnknownTypeError: No definition of the type was found.
    """
    connect = system.client if changes else system.reader
    # This runs in a thread, because the type's definition may have to come from another machine.
    reference = await run_in_thread(connect, name, type_name)
    with reference:
        return await answer(reference.entity.call_server_async(request), name, timeout_s)


async def answer(future: Awaitable[T], name: str, timeout_s: float = PATIENCE_S) -> T:
    """Wait in NiceGUI's loop for the answer of a node, and return the answer.

    Args:
        future: The future of the answer.
        name: The name of the service or action, for the error.
        timeout_s: The longest wait, in seconds.

    Raises:
        NoAnswerError: The node did not answer in time.
        ServiceError: There is no server, its callback raised an error, or the server ended.
    """
    try:
        return await asyncio.wait_for(future, timeout_s)
    except asyncio.TimeoutError:
        raise NoAnswerError(name, timeout_s) from None


async def run_in_thread(
    function: Callable[..., T], *arguments: Any, threads: ThreadPoolExecutor = WAITING
) -> T:
    """Run a slow function in a thread and return its result. NiceGUI's loop is not blocked.

    Args:
        function: The function. After a cancellation of this call, the function runs on.
        arguments: Its arguments.
        threads: `WAITING`, `READING`, `EXPORTING` or `DRAWING`.
    """
    # `run.io_bound` of NiceGUI has one small pool for everything, and returns None if it is
    # cancelled.
    call_function = functools.partial(function, *arguments)
    return await asyncio.get_running_loop().run_in_executor(threads, call_function)


def show_error(error: Exception) -> None:
    """Show an error's message in the page."""
    ui.notify(str(error), type="negative", multi_line=True, classes="zb-complaint")


def with_errors_shown(
    action: Callable[..., Coroutine[Any, Any, None]],
) -> Callable[..., Coroutine[Any, Any, None]]:
    """Return an event handler that shows errors in the page."""

    @functools.wraps(action)  # NiceGUI inspects the parameters of a handler
    async def handler(*arguments: Any) -> None:
        try:
            await action(*arguments)
        except ZbotError as error:
            show_error(error)

    return handler
