"""Session of one client, with the messages that wait for the client."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.interfaces import get_interface
from zbot.observer.serving.client_threads import ClientThreads
from zbot.web.rosbridge.bridge import full_type
from zbot.web.rosbridge.client_message import RosbridgeError
from zbot.web.rosbridge.frame import frames
from zbot.web.rosbridge.outbox import Outbox

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.web.rosbridge.bridge import Bridge
    from zbot.web.rosbridge.client_message import ClientMessage

_LEVELS = ("none", "error", "warning", "info")


class UnknownHereError(ZbotError):
    """This machine has no definition of a type, and this thread must not ask the nodes."""


class Session:
    """Session of one client, through which the operations answer.

    Args:
        bridge: The node and the executor of all clients.
        wake: A quick function, called by any thread when `outbox` has something to send.
        call_later: Function that calls a quick function after a delay in seconds. It returns a
            function that prevents this call: call it at most once. Any thread may call both.

    Attributes:
        bridge: The node and the executor of all clients.
        call_later: The argument `call_later`.
        may_ask: Whether the operation that runs now may wait for answers of nodes.
        outbox: The messages that wait for the client.
        waiting_threads: The client's share of the threads that wait for answers of nodes.
    """

    def __init__(
        self,
        bridge: Bridge,
        wake: Callable[[], None],
        call_later: Callable[[float, Callable[[], None]], Callable[[], None]],
    ) -> None:
        self.bridge = bridge
        self.call_later = call_later
        self.may_ask = False
        self.outbox = Outbox(wake)
        self.waiting_threads = ClientThreads(bridge.waiting_threads)
        self._level = "error"

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

    def set_level(self, message: ClientMessage) -> None:
        """Set the least important level of status messages that the client wants."""
        level = message.word("level")
        if level not in _LEVELS:
            raise RosbridgeError(f"the level {level!r} is not one of {', '.join(_LEVELS)}")
        self._level = level

    def interface(self, kind: str, name: str) -> Any:
        """Return the class of a type. The arguments and the errors are those of `Bridge.interface`.

        Raises:
            UnknownHereError: Only the nodes may know the type, and `may_ask` is false.
        """
        if self.may_ask:
            return self.bridge.interface(kind, name)
        try:
            return get_interface(full_type(kind, name))
        except LookupError:
            raise UnknownHereError(name) from None

    def require_writable(self, what: str) -> None:
        """Check that clients may change something.

        Raises:
            RosbridgeError: The server is read-only.
        """
        if self.bridge.is_read_only:
            raise RosbridgeError(f"{what} is not possible: zbot web runs with --read-only")
