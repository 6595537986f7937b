"""Session of one client. It executes the client's messages, and collects the answers."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

from zbot.web.rosbridge.action_operations import ActionOperations
from zbot.web.rosbridge.client_message import Fragments, RosbridgeError, read_message
from zbot.web.rosbridge.frame import frames
from zbot.web.rosbridge.outbox import Outbox
from zbot.web.rosbridge.service_operations import ServiceOperations
from zbot.web.rosbridge.topic_operations import TopicOperations

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.web.rosbridge.bridge import Bridge
    from zbot.web.rosbridge.client_message import ClientMessage

_LEVELS = ("none", "error", "warning", "info")


class Session:
    """Session of one client. Only one thread at a time may call `take`.

    Args:
        bridge: The node and the executor of all clients.
        wake: A quick function, called by any thread when `outbox` has something to send.
        call_later: Function that calls a quick function after a delay in seconds. Any thread may
            call `call_later`.

    Attributes:
        bridge: The node and the executor of all clients.
        call_later: The argument `call_later`.
        outbox: The messages that wait for the client.
    """

    def __init__(
        self,
        bridge: Bridge,
        wake: Callable[[], None],
        call_later: Callable[[float, Callable[[], None]], None],
    ) -> None:
        self.bridge = bridge
        self.call_later = call_later
        self.outbox = Outbox(wake)
        self._lock = threading.RLock()
        self._is_closed = False
        self._level = "error"
        self._fragments = Fragments()
        self._topics = TopicOperations(self)
        self._services = ServiceOperations(self)
        self._actions = ActionOperations(self)
        self._operations: dict[str, Callable[[ClientMessage], None]] = {
            "fragment": self._defragment,
            "set_level": self._set_level,
            "status_level": self._set_level,
            **self._topics.operations,
            **self._services.operations,
            **self._actions.operations,
        }

    def take(self, data: str | bytes) -> None:
        """Execute a message of the client. If there is an error, send it as a status message."""
        with self._lock:
            if not self._is_closed:
                self._carry_out(data)

    def _carry_out(self, data: str | bytes) -> None:
        message: ClientMessage | None = None
        try:
            message = read_message(data)
            self._operation(message.op)(message)
        except Exception as error:  # noqa: BLE001 - the other messages of the client go on
            self.report("error", self.bridge.sentence(error), message)

    def _operation(self, name: str) -> Callable[[ClientMessage], None]:
        operation = self._operations.get(name)
        if operation is None:
            known = ", ".join(sorted(self._operations))
            raise RosbridgeError(f"there is no operation {name!r}, but {known}")
        return operation

    def send(
        self,
        fields: dict[str, Any],
        compression: str = "none",
        fragment_size: int | None = None,
    ) -> None:
        """Send a message that is never dropped. Fields with `None` are left out."""
        kept = {name: value for name, value in fields.items() if value is not None}
        self.outbox.reply(frames(kept, compression, fragment_size))

    def report(self, level: str, text: str, message: ClientMessage | None = None) -> None:
        """Send a status message, if the client wants messages of this level."""
        if _LEVELS.index(level) <= _LEVELS.index(self._level):
            op = None if message is None else message.op
            self.send(
                {
                    "op": "status",
                    "id": None if message is None else message.id,
                    "level": level,
                    "msg": f"{op}: {text}" if op else text,
                }
            )

    def require_writable(self, what: str) -> None:
        """Check that clients may change something.

        Raises:
            RosbridgeError: The server is read-only.
        """
        if self.bridge.is_read_only:
            raise RosbridgeError(f"{what} is not possible: zbot web runs with --read-only")

    def close(self) -> None:
        """Destroy everything that the client has created. Goals that it has sent continue."""
        with self._lock:
            self._is_closed = True
            self._topics.close()
            self._services.close()
            self._actions.close()

    def _defragment(self, message: ClientMessage) -> None:
        whole = self._fragments.add(message)
        if whole is not None:
            inner = read_message(whole)
            if inner.op == "fragment":
                raise RosbridgeError("a message in fragments cannot be a fragment")
            self.take(whole)

    def _set_level(self, message: ClientMessage) -> None:
        level = message.word("level")
        if level not in _LEVELS:
            raise RosbridgeError(f"the level {level!r} is not one of {', '.join(_LEVELS)}")
        self._level = level
