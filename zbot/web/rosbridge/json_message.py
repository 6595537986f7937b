"""Conversion of JSON that a client sent into a message."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.interfaces import FieldType, message_spec_of
from zbot.interfaces.default_size import DefaultMemory
from zbot.interfaces.message_reader import FieldMisfitError, MessageReader
from zbot.observer.serving.client_budget import MAX_DEFAULT_BYTES
from zbot.web.rosbridge.client_message import RosbridgeError

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.interfaces.slot import Slot

_HEADER = "std_msgs/msg/Header"
_TIMES = ("builtin_interfaces/msg/Time", "builtin_interfaces/msg/Duration")
#: ROS 1's names of the fields of a time, which many web pages still use.
_OLD_TIME_FIELDS = {"secs": "sec", "nsecs": "nanosec"}


def message_from_json(
    message_type: type[Any], value: Any, now: Callable[[], Any], size: int = 0
) -> Any:
    """Return a message with the fields in a JSON object.

    A header without a stamp gets the current time. If a header field of the message is missing in
    the object, the header gets the current time too.

    Args:
        message_type: The message's class. It may also be a part of a service or an action.
        value: The JSON object. A list is allowed too: it has the values of the first fields.
        now: Returns the current time as a `Time` message.
        size: The length of the client's text. It limits the memory of values that are left out.

    Raises:
        RosbridgeError: The value does not fit the type. The error's text contains the
            path of the field.
    """
    spec = message_spec_of(message_type)
    if isinstance(value, list):
        if len(value) > len(spec.fields):
            raise RosbridgeError(f"{spec.name} has {len(spec.fields)} fields, not {len(value)}")
        value = {field.name: item for field, item in zip(spec.fields, value, strict=False)}
    memory = DefaultMemory(size, MAX_DEFAULT_BYTES)
    try:
        message = _Reader(now, memory).stamped(spec.name, message_type, value, "")
    except FieldMisfitError as error:
        raise RosbridgeError(error.sentence) from None
    for field in spec.fields:
        if field.type == FieldType(_HEADER) and field.name not in value:
            getattr(message, field.name).stamp = now()
    return message


class _Reader(MessageReader):
    """Reader of JSON that knows rosbridge's forms of a time and of a header."""

    def __init__(self, now: Callable[[], Any], memory: DefaultMemory) -> None:
        super().__init__(memory)
        self._now = now

    def nested(self, slot: Slot, value: Any, path: str) -> Any:
        return self.stamped(slot.type.base, slot.message_type, value, path)

    def stamped(self, type_name: str, message_type: type[Any], value: Any, path: str) -> Any:
        """Return a message. A header without a stamp has the current time."""
        if type_name in _TIMES:
            if value == "now" and type_name == _TIMES[0]:
                return self._now()
            if isinstance(value, dict):
                value = {_OLD_TIME_FIELDS.get(name, name): item for name, item in value.items()}
        message = self.message(message_type, value, path)
        if type_name == _HEADER and "stamp" not in value:
            message.stamp = self._now()
        return message
