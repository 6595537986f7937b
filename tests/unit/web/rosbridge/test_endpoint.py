"""Tests of the WebSocket where clients of rosbridge connect."""

from __future__ import annotations

import asyncio
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

from zbot.serving.client_budget import Clients
from zbot.web.rosbridge import endpoint
from zbot.web.rosbridge.client_message import RosbridgeError

if TYPE_CHECKING:
    from collections.abc import Callable


class Socket:
    """Client that only connects."""

    client = None

    async def accept(self) -> None: ...

    async def close(self, _code: int, _reason: str) -> None: ...


def test_news_after_the_end_of_the_server_are_dropped(monkeypatch: pytest.MonkeyPatch) -> None:
    given: list[Callable[..., None]] = []

    def session(_bridge: Any, *functions: Callable[..., None]) -> None:
        given.extend(functions)
        raise RosbridgeError("enough")

    monkeypatch.setattr(endpoint, "Session", session)
    bridge: Any = SimpleNamespace(clients=Clients())
    socket: Any = Socket()
    loop = asyncio.new_event_loop()
    with pytest.raises(RosbridgeError, match="enough"):
        loop.run_until_complete(endpoint.endpoint(bridge)(socket))
    loop.close()
    wake, call_later = given
    wake()
    call_later(1.0, wake)
