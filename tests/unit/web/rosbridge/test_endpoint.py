"""Tests of the WebSocket where clients of rosbridge connect."""

from __future__ import annotations

import asyncio
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

from zbot.web.rosbridge.client_message import RosbridgeError
from zbot.web.rosbridge.endpoint import endpoint

if TYPE_CHECKING:
    from collections.abc import Callable


class Socket:
    """Client that only connects."""

    async def accept(self) -> None: ...

    async def close(self, _code: int, _reason: str) -> None: ...


def test_news_after_the_end_of_the_server_are_dropped() -> None:
    given: list[Callable[..., None]] = []

    def open_session(*functions: Callable[..., None]) -> None:
        given.extend(functions)
        raise RosbridgeError("enough")

    bridge: Any = SimpleNamespace(open_session=open_session)
    socket: Any = Socket()
    loop = asyncio.new_event_loop()
    loop.run_until_complete(endpoint(bridge)(socket))
    loop.close()
    wake, call_later = given
    wake()
    call_later(1.0, wake)
