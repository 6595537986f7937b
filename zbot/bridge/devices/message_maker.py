"""Maker of messages of one topic from the values of a device, and the texts of messages."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from zbot.bridge.devices.errors import UnreadableError
from zbot.interfaces.default_size import DefaultMemory
from zbot.interfaces.field_path import FieldPath
from zbot.interfaces.message_reader import FieldMisfitError, MessageReader
from zbot.interfaces.plain_value import json_value
from zbot.interfaces.slot import slots_of
from zbot.interfaces.yaml_message import YamlReader

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.bridge.devices.topic_type import TopicType

_YAML = YamlReader()
_HEADER = "std_msgs/msg/Header"


class MessageMaker:
    """Maker of messages. A header without a time gets the present time: boards have no clock.

    Args:
        kind: The type of the topic.
        now: Function that returns the present time as a message.
    """

    def __init__(self, kind: TopicType, now: Callable[[], Any]) -> None:
        self.kind = kind
        self._type, self._now = kind.message_type, now
        self._path = kind.field.split(".") if kind.field else []
        header = slots_of(self._type).get("header")
        self._has_header = header is not None and header.type.base == _HEADER

    def make(self, value: Any) -> Any:
        """Return a message.

        Args:
            value: A word, a list of numbers, or the dictionary of a whole message.

        Raises:
            UnreadableError: The value does not fit the type.
        """
        try:
            message = self._message(value)
        except FieldMisfitError as error:
            raise UnreadableError(f"the value is no {self.kind}", str(error)) from None
        if self._has_header and not (message.header.stamp.sec or message.header.stamp.nanosec):
            message.header.stamp = self._now()
        return message

    def _message(self, value: Any) -> Any:
        if isinstance(value, dict):
            return _json().message(self._type, value)
        if isinstance(value, list) and not self._path:
            return _json().message(self._type, {"data": value})
        if not self._path:
            raise UnreadableError(f"one value is no {self.kind}", "name the field after the type")
        for name in reversed(self._path):
            value = {name: value}
        return _YAML.message(self._type, value)


def text_of(message: Any, field: str, bools: tuple[str, str]) -> str:
    """Return a message as text: a single value as it is, and other messages as JSON.

    Args:
        message: The message.
        field: Path of the field to write. It may be empty: the whole message is written.
        bools: The texts for false and true.
    """
    value = FieldPath(field).select(message) if field else message
    if isinstance(value, bool):
        return bools[value]
    if isinstance(value, (int, float, str)):
        return str(value)
    if isinstance(value, bytes) and len(value) == 1:
        return str(value[0])
    return json.dumps(json_value(value), separators=(",", ":"), ensure_ascii=False)


def _json() -> MessageReader:
    return MessageReader(DefaultMemory(0))  # the values come from another machine
