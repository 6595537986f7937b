"""Conversion of JSON that a client sent into a message."""

from __future__ import annotations

import base64
import binascii
import math
from typing import TYPE_CHECKING, Any

from zbot.errors.suggestion import did_you_mean
from zbot.interfaces import get_message, message_spec_of
from zbot.interfaces.spec import FLOAT32_MAX, INTEGER_RANGES, FieldType
from zbot.web.rosbridge.client_message import RosbridgeError

if TYPE_CHECKING:
    from collections.abc import Callable

_HEADER = "std_msgs/msg/Header"
_TIMES = ("builtin_interfaces/msg/Time", "builtin_interfaces/msg/Duration")
_OCTETS = ("uint8", "char", "byte")
#: ROS 1's names of the fields of a time, which many web pages still use.
_OLD_TIME_FIELDS = {"secs": "sec", "nsecs": "nanosec"}


def message_from_json(message_type: type[Any], value: Any, now: Callable[[], Any]) -> Any:
    """Return a message with the fields in a JSON object. Missing fields get their defaults.

    A header without a stamp gets the current time. If a header field of the message is missing in
    the object, the header gets the current time too. In a field for floats, `null` means NaN. A
    field for octets may be base64 or a list of numbers.

    Args:
        message_type: The message's class. It may also be a part of a service or an action.
        value: The JSON object. A list is allowed too: it has the values of the first fields.
        now: Returns the current time as a `Time` message.

    Raises:
        RosbridgeError: The value does not fit the type. The error's text contains the
            path of the field.
    """
    spec = message_spec_of(message_type)
    if isinstance(value, list):
        if len(value) > len(spec.fields):
            raise RosbridgeError(f"{spec.name} has {len(spec.fields)} fields, not {len(value)}")
        value = {field.name: one for field, one in zip(spec.fields, value, strict=False)}
    converter = _Converter(now)
    message = converter.message(message_type, value, "")
    for field in spec.fields:
        if field.type == FieldType(_HEADER) and field.name not in value:
            getattr(message, field.name).stamp = now()
    return message


class _Converter:
    def __init__(self, now: Callable[[], Any]) -> None:
        self._now = now

    def message(self, message_type: type[Any], value: Any, path: str) -> Any:
        spec = message_spec_of(message_type)
        if spec.name == _TIMES[0] and value == "now":
            return self._now()
        if not isinstance(value, dict):
            raise _misfit(path, f"an object with the fields of {spec.name}", value)
        if spec.name in _TIMES:
            value = {_OLD_TIME_FIELDS.get(name, name): one for name, one in value.items()}
        message = message_type()
        types = {field.name: field.type for field in spec.fields}
        for name, one in value.items():
            if name not in types:
                guess = did_you_mean(name, types, before="; ")
                raise RosbridgeError(f"{spec.name} has no field {name!r}{guess}")
            where = f"{path}.{name}" if path else name
            setattr(message, name, self._value(types[name], one, where))
        if spec.name == _HEADER and "stamp" not in value:
            message.stamp = self._now()
        return message

    def _value(self, kind: FieldType, value: Any, path: str) -> Any:
        if kind.kind == "scalar":
            return self._item(kind, value, path)
        if kind.base in _OCTETS and isinstance(value, str):
            value = list(_octets(value, path))
        if not isinstance(value, list):
            raise _misfit(path, "a list", value)
        if kind.kind == "array" and len(value) != kind.size:
            raise RosbridgeError(f"{path} needs {kind.size} values, not {len(value)}")
        if kind.size and len(value) > kind.size:
            raise RosbridgeError(f"{path} can have {kind.size} values, not {len(value)}")
        item = FieldType(kind.base, string_bound=kind.string_bound)
        return [self._item(item, one, f"{path}[{index}]") for index, one in enumerate(value)]

    def _item(self, kind: FieldType, value: Any, path: str) -> Any:
        if kind.is_message:
            return self.message(get_message(kind.base), value, path)
        if kind.is_string:
            return _string(kind, value, path)
        if kind.base == "bool":
            if not isinstance(value, bool):
                raise _misfit(path, "true or false", value)
            return value
        if kind.base.startswith("float"):
            return _float(kind.base, value, path)
        if kind.base == "byte":
            return bytes([_integer("uint8", value, path)])
        return _integer(kind.base, value, path)


def _string(kind: FieldType, value: Any, path: str) -> str:
    if not isinstance(value, str):
        raise _misfit(path, "a string", value)
    if kind.string_bound and len(value) > kind.string_bound:
        raise RosbridgeError(f"{path} can have {kind.string_bound} characters, not {len(value)}")
    return value


def _float(base: str, value: Any, path: str) -> float:
    if value is None:
        return math.nan  # JSON has no NaN and no infinities
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise _misfit(path, "a number", value)
    try:
        number = float(value)
    except OverflowError:
        raise RosbridgeError(f"{path} is too large for {base}") from None
    if base == "float32" and abs(number) > FLOAT32_MAX:
        raise RosbridgeError(f"{path} is too large for {base}")
    return number


def _integer(base: str, value: Any, path: str) -> int:
    if isinstance(value, float) and value.is_integer():
        value = int(value)  # JavaScript writes large integers as 1e21
    if isinstance(value, bool) or not isinstance(value, int):
        raise _misfit(path, "an integer", value)
    low, high = INTEGER_RANGES[base]
    if not low <= value <= high:
        raise RosbridgeError(f"{path} must be from {low} to {high}")
    return value


def _octets(text: str, path: str) -> bytes:
    try:
        return base64.b64decode(text, validate=True)
    except (binascii.Error, ValueError):
        raise RosbridgeError(f"{path} is not valid base64") from None


def _misfit(path: str, expected: str, value: Any) -> RosbridgeError:
    names = {dict: "an object", list: "a list", str: "a string", bool: "a boolean"}
    found = "null" if value is None else names.get(type(value), "a number")
    where = f"{path} needs {expected}" if path else f"the message must be {expected}"
    return RosbridgeError(f"{where}, not {found}")
