"""Topics on which one client of the server for Foxglove publishes."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.interfaces.default_size import DefaultMemory
from zbot.interfaces.message_reader import MessageReader
from zbot.observer.errors import ViewerError
from zbot.observer.serving.client_budget import MAX_DEFAULT_BYTES, MAX_PUBLISHED, OverBudgetError
from zbot.text.json_reader import read_json_object
from zbot.wire.serialization import deserialize_message

if TYPE_CHECKING:
    from zbot.observer.system import System

_ENCODINGS = ("cdr", "json")


class Publishing:
    """Publishers of one client. The methods may block, so the server calls them in other threads.

    Args:
        system: The running system.
    """

    def __init__(self, system: System) -> None:
        self._system = system
        self._lock = threading.Lock()
        self._is_closed = False
        self._channels: dict[int, tuple[Any, Any, str]] = {}

    def advertise(self, channel: Any) -> None:
        """Create the publisher of a channel, which the client describes.

        Raises:
            ZbotError: The description is not valid, or the client has too many channels.
        """
        topic, type_name, encoding = (
            _field(channel, name, str) for name in ("topic", "schemaName", "encoding")
        )
        number = _field(channel, "id", int)
        if encoding not in _ENCODINGS:
            raise ViewerError(f"the encoding {encoding!r} is not known: use cdr or json")
        with self._lock:
            if self._is_closed:
                return
            if number in self._channels:
                raise ViewerError(f"you have a channel with the id {number} already")
            if len(self._channels) >= MAX_PUBLISHED:
                raise OverBudgetError(f"a client can publish on {MAX_PUBLISHED} topics")
            try:
                reference = self._system.publisher(topic, type_name)
                message_type = self._system.interface(type_name)
            except ZbotError as error:
                raise ViewerError(f"you cannot publish on {topic}: {error}") from error
            self._channels[number] = reference, message_type, encoding

    def unadvertise(self, number: int) -> None:
        """Release the publisher of a channel. A channel that does not exist is ignored."""
        with self._lock:
            known = self._channels.pop(number, None)
        if known is not None:
            known[0].release()

    def publish(self, number: int, data: bytes) -> None:
        """Publish a message.

        Raises:
            ZbotError: The client has no such channel, or the message does not fit its type.
        """
        known = self._channels.get(number)
        if known is None:
            raise ViewerError(f"you have no channel with the id {number}")
        reference, message_type, encoding = known
        try:
            reference.entity.publish(client_message(data, message_type, encoding))
        except (ZbotError, ValueError, TypeError) as error:
            raise ViewerError(f"your message was not published: {error}") from error

    def close(self) -> None:
        """Release all publishers."""
        with self._lock:
            self._is_closed = True
            for reference, _, _ in self._channels.values():
                reference.release()
            self._channels.clear()


def _field(channel: Any, name: str, kind: type) -> Any:
    value = channel.get(name) if isinstance(channel, dict) else None
    if not isinstance(value, kind) or isinstance(value, bool):
        raise ViewerError(f"a channel needs the field {name!r}")
    return value


def client_message(data: bytes, cls: Any, encoding: str) -> Any:
    """Return a message that a client has sent.

    Raises:
        ZbotError: The bytes or the values do not fit the type.
    """
    if encoding == "cdr":
        return deserialize_message(data, cls)
    memory = DefaultMemory(len(data), MAX_DEFAULT_BYTES)
    return MessageReader(memory).message(cls, read_json_object(data))
