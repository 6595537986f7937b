"""Wait of a server's event loop for the signal that ends the server."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

from zbot.threads.wakeup import LONGEST_WAIT_S

if TYPE_CHECKING:
    from collections.abc import Callable


async def serve_until_signal(server: asyncio.Server, ready: Callable[[], object]) -> None:
    """Serve until a signal raises its exception in this thread, and then close the server.

    Clients that are still connected do not delay the end.

    Args:
        server: The server. It listens already.
        ready: Called once in the event loop, before the wait.
    """
    try:
        ready()
        # A signal that comes just before the loop goes to sleep, or that another thread gets, does
        # not wake the loop. So the loop must not sleep for ever.
        while True:
            await asyncio.sleep(LONGEST_WAIT_S)
    finally:
        # `async with` and `serve_forever` would wait for the clients, which may stay for ever.
        server.close()
