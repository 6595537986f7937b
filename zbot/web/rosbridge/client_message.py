"""Messages that clients of rosbridge send, their limits, and the error for a wrong message."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from zbot.errors import ZbotError
from zbot.observer.serving.client_budget import MAX_MESSAGE_BYTES
from zbot.text.json_reader import JsonError, read_json_object

#: Longest name, type and id, in characters.
_MAX_WORD = 1000
_MAX_FRAGMENTED_MESSAGES = 16
#: Size of a fragment without its characters, in bytes. With it, empty fragments count too.
_SIZE_OF_PART = 100


class RosbridgeError(ZbotError, ValueError):
    """A client's message cannot be executed. The client gets the text of this error."""


class ClientMessage:
    """One message of a client: its operation and its fields.

    Args:
        fields: The message's fields.
        size: The length of the text of the message.

    Raises:
        RosbridgeError: The message has no operation, or its id is not a string or an integer.
    """

    def __init__(self, fields: dict[str, Any], size: int = 0) -> None:
        self._fields = fields
        self.size = size
        self.id = fields.get("id")
        if isinstance(self.id, bool) or not isinstance(self.id, (str, int, type(None))):
            self.id = None
            raise RosbridgeError("the field 'id' must be a string or an integer")
        if isinstance(self.id, str) and len(self.id) > _MAX_WORD:
            self.id = None
            raise RosbridgeError(f"the field 'id' is longer than {_MAX_WORD} characters")
        self.op = self.word("op")

    def get(self, name: str) -> Any:
        """Return a field of any type, or `None` if it is missing."""
        return self._fields.get(name)

    def word(self, name: str, default: str | None = None) -> str:
        """Return a string that is not empty and has at most 1000 characters.

        Raises:
            RosbridgeError: The field is missing and has no default, or it is not such a string.
        """
        value = self._fields.get(name)
        if value is None and default is not None:
            return default
        if not isinstance(value, str) or not 0 < len(value) <= _MAX_WORD:
            raise RosbridgeError(
                f"the field {name!r} must be a string of 1 to {_MAX_WORD} characters"
            )
        return value

    def text(self, name: str) -> str:
        """Return a string of any length.

        Raises:
            RosbridgeError: The field is missing or is not a string.
        """
        value = self._fields.get(name)
        if not isinstance(value, str):
            raise RosbridgeError(f"the field {name!r} must be a string")
        return value

    def number(self, name: str, default: float, *, least: float = 0, most: float = 1e9) -> float:
        """Return a number in a range. `null` means the default.

        Raises:
            RosbridgeError: The field is not a number in the range.
        """
        value = self._fields.get(name)
        if value is None:
            return default
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise RosbridgeError(f"the field {name!r} must be a number")
        if not least <= value <= most:
            raise RosbridgeError(f"the field {name!r} must be from {least:g} to {most:g}")
        return value

    def flag(self, name: str, default: bool = False) -> bool:
        """Return a boolean. `null` means the default.

        Raises:
            RosbridgeError: The field is not a boolean.
        """
        value = self._fields.get(name)
        if value is None:
            return default
        if not isinstance(value, bool):
            raise RosbridgeError(f"the field {name!r} must be true or false")
        return value


def read_message(data: str | bytes) -> ClientMessage:
    """Parse a text, and return the message that it contains.

    Raises:
        RosbridgeError: The text is not a JSON object with an operation, is too long, or has too
            many levels.
    """
    if isinstance(data, bytes):
        raise RosbridgeError("a binary message cannot be read: send JSON as text")
    try:
        return ClientMessage(read_json_object(data, MAX_MESSAGE_BYTES), len(data))
    except JsonError as error:
        raise RosbridgeError(str(error)) from error


@dataclass
class _Incomplete:
    total: int
    parts: dict[int, str] = field(default_factory=dict)
    size: int = 0


class Fragments:
    """Parts of messages that a client sends in fragments.

    At most 16 messages may be incomplete, and their parts may have at most 16 MiB in all. Beyond
    a limit, the oldest incomplete message is dropped, and the client gets an error.
    """

    def __init__(self) -> None:
        self._incomplete: dict[str | int, _Incomplete] = {}

    def add(self, fragment: ClientMessage) -> str | None:
        """Keep a fragment. If it completes a message, return the message's text, otherwise None.

        Raises:
            RosbridgeError: The fragment is not valid, or the parts are too long.
        """
        total = int(fragment.number("total", 0, least=1, most=MAX_MESSAGE_BYTES))
        number = int(fragment.number("num", -1, least=0, most=MAX_MESSAGE_BYTES))
        data = fragment.text("data")
        if fragment.id is None or not 0 <= number < total:
            raise RosbridgeError("a fragment needs an id, a total and a num from 0 to total - 1")
        found = self._incomplete.setdefault(fragment.id, _Incomplete(total))
        if found.total != total:
            del self._incomplete[fragment.id]
            raise RosbridgeError("the fragments of a message must have the same total")
        if number not in found.parts:
            found.parts[number] = data
            found.size += len(data) + _SIZE_OF_PART
        if len(found.parts) == total:
            del self._incomplete[fragment.id]
            return "".join(found.parts[index] for index in range(total))
        self._make_room()
        return None

    def _make_room(self) -> None:
        is_long = sum(message.size for message in self._incomplete.values()) > MAX_MESSAGE_BYTES
        if is_long or len(self._incomplete) > _MAX_FRAGMENTED_MESSAGES:
            del self._incomplete[next(iter(self._incomplete))]
            what = f"need more than {MAX_MESSAGE_BYTES} bytes" if is_long else "are too many"
            raise RosbridgeError(f"the incomplete messages {what}: the oldest one is forgotten")
