"""Client of rosbridge without a websocket."""

from __future__ import annotations

import json
import threading
from typing import TYPE_CHECKING, Any

from tests.conftest import wait_until
from zbot.web.rosbridge.dispatcher import Dispatcher
from zbot.web.rosbridge.session import Session

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.web.rosbridge.bridge import Bridge


class WebProgram:
    """Client of rosbridge, which keeps what it receives."""

    def __init__(self, bridge: Bridge) -> None:
        self.session = Session(bridge, lambda: None, self._call_later)
        self.dispatcher = Dispatcher(self.session)
        self.received: list[dict[str, Any]] = []

    @staticmethod
    def _call_later(delay_s: float, function: Callable[[], None]) -> Callable[[], None]:
        timer = threading.Timer(delay_s, function)
        timer.start()
        return timer.cancel

    def send(self, op: str, **fields: Any) -> None:
        if not self.dispatcher.take(json.dumps({"op": op, **fields})):
            self.dispatcher.finish()

    def read(self) -> list[dict[str, Any]]:
        self.received += map(json.loads, self.session.outbox.take().frames)
        return self.received

    def wait_for(self, op: str, **fields: Any) -> dict[str, Any]:
        """Return the first message with these fields, and forget it."""
        found: list[dict[str, Any]] = []

        def has_come() -> bool:
            wanted = {"op": op, **fields}
            found[:] = [answer for answer in self.read() if wanted.items() <= answer.items()]
            return bool(found)

        assert wait_until(has_come, 10), self.received
        self.received.remove(found[0])
        return found[0]

    def call(self, service: str, /, **args: Any) -> Any:
        self.send("call_service", service=service, args=args, id=service)
        answer = self.wait_for("service_response", id=service)
        assert answer["result"], answer
        return answer["values"]


def repeat_until_sent(publisher: Any, message: Any, web: WebProgram, op: str) -> dict[str, Any]:
    def attempt() -> bool:
        publisher.publish(message)
        return any(answer["op"] == op for answer in web.read())

    assert wait_until(attempt, 10)
    return web.wait_for(op)
