"""Conversion of ROS 1's messages: from ROS 1's bytes to messages of ROS 2."""

from __future__ import annotations

import re
import struct
from array import array
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeAlias

from zbot.bag.errors import BagTypeError
from zbot.errors import shortened
from zbot.interfaces import get_message, get_spec
from zbot.interfaces.spec import TYPECODES

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    Decode: TypeAlias = Callable[[bytes, int], tuple[Any, int]]

_SPLIT = re.compile(r"^=+[ \t]*\r?\n", re.MULTILINE)
_FIELD = re.compile(r"(?P<base>[\w/]+)(?P<array>\[(?P<size>[0-9]{0,9})\])?\s+(?P<name>\w+)\s*\Z")
_MOST_LEVELS = 20
#: Format for `struct` and `array` of each type of ROS 1.
_FORMATS = {"bool": "?", "byte": "b", **TYPECODES}
#: Types of ROS 1 without a package, with their types in ROS 2 and their formats for `struct`.
_TIMES = {
    "time": ("builtin_interfaces/Time", "<II"),
    "duration": ("builtin_interfaces/Duration", "<ii"),
}
_HEADER = "std_msgs/Header"


@dataclass(frozen=True)
class Ros1Field:
    """Field of a ROS 1 message."""

    base: str  #: `float64`, `time`, or a message with its package: `geometry_msgs/Point`
    name: str
    size: int | None  #: `None` for one value, -1 for a sequence, else the length of the array


def read_definitions(type_name: str, text: str) -> dict[str, list[Ros1Field]]:
    """Return the fields of a message and of all messages inside it.

    Args:
        type_name: `sensor_msgs/Image`.
        text: The definition in a bag.

    Raises:
        BagTypeError: A line is not a field.
    """
    first, *others = _SPLIT.split(text)
    parts = {type_name: first}
    for other in others:
        title, _, body = other.partition("\n")
        parts[title.strip().removeprefix("MSG:").strip()] = body
    known = frozenset(parts)
    return {name: _fields(name, body, known) for name, body in parts.items()}


def ros2_name(type_name: str) -> str:
    """Return ROS 2's name of a type: `sensor_msgs/msg/Image` for `sensor_msgs/Image`."""
    package, _, name = type_name.partition("/")
    return f"{package}/msg/{name}"


def ros2_text(type_name: str, definitions: Mapping[str, list[Ros1Field]]) -> str:
    """Return a definition in ROS 2's language, for a type that is not known here.

    The field `seq` of headers is left out, because ROS 2 does not have it.
    """
    texts = []
    for name, fields in definitions.items():
        if name != _HEADER:
            lines = "".join(f"{_ros2_type(field)} {field.name.lower()}\n" for field in fields)
            texts.append(lines if name == type_name else f"MSG: {name}\n{lines}")
    own = texts.index(next(text for text in texts if not text.startswith("MSG: ")))
    return f"{'=' * 80}\n".join([texts.pop(own), *texts])


def decoder(type_name: str, definitions: Mapping[str, list[Ros1Field]]) -> Callable[[bytes], Any]:
    """Return a function that makes a message of ROS 2 from ROS 1's bytes.

    Fields belong together if their names differ only in capital letters. A field that only ROS 1's
    message has is left out. A field that only ROS 2's message has gets its default.

    Raises:
        BagTypeError: The definition is incomplete.
    """
    decode = _Decoders(definitions).message(type_name, ros2_name(type_name), 0)
    return lambda data: decode(data, 0)[0]


def _fields(type_name: str, body: str, known: frozenset[str]) -> list[Ros1Field]:
    package = type_name.partition("/")[0]
    found = []
    for line in body.splitlines():
        text = line.partition("#")[0].strip()
        if not text or "=" in text:
            continue  # empty, or a constant
        match = _FIELD.fullmatch(text)
        if match is None:
            raise BagTypeError(type_name, f"{shortened(text)} is no field of a ROS 1 message")
        base = match["base"]
        if base == "Header":
            base = _HEADER
        elif "/" not in base and base not in {*_FORMATS, *_TIMES, "string"}:
            base = f"{package}/{base}"
        if "/" in base and base not in known:
            raise BagTypeError(type_name, f"the definition of {base} is missing")
        size = None if match["array"] is None else int(match["size"] or -1)
        found.append(Ros1Field(base, match["name"], size))
    return found


def _ros2_type(field: Ros1Field) -> str:
    base = _TIMES[field.base][0] if field.base in _TIMES else field.base
    base = "int8" if base == "byte" else base
    if field.size is None:
        return base
    return f"{base}[]" if field.size < 0 else f"{base}[{field.size}]"


class _Decoders:
    """Decoders of one message and of all messages inside it. Each pair of types has one decoder.

    Args:
        definitions: The fields of ROS 1's messages.
    """

    def __init__(self, definitions: Mapping[str, list[Ros1Field]]) -> None:
        self._definitions = definitions
        self._made: dict[tuple[str, str], Decode] = {}

    def message(self, name: str, target: str, level: int) -> Decode:
        """Return the decoder from ROS 1's message to ROS 2's."""
        if name not in self._definitions or level > _MOST_LEVELS:
            raise BagTypeError(name, "its definition is incomplete")
        if (name, target) not in self._made:
            self._made[name, target] = self._new_message(name, target, level)
        return self._made[name, target]

    def _new_message(self, name: str, target: str, level: int) -> Decode:
        cls: Any = get_message(target)
        spec: Any = get_spec(target)
        places = {field.name.lower(): field for field in spec.fields}
        steps: list[tuple[str, Decode]] = []
        for field in self._definitions[name]:
            place = places.get(field.name.lower())
            if place is not None:
                own_name, base = place.name, place.type.base
            else:
                own_name, base = "", ros2_name(field.base) if "/" in field.base else field.base
            if "/" in field.base and "/" not in base:
                reason = f"the field {field.name} is a {field.base}, and a {base} in ROS 2"
                raise BagTypeError(name, reason)
            steps.append((own_name, self._value(field, base, level)))

        def decode(data: bytes, position: int) -> tuple[Any, int]:
            values = {}
            for own_name, step in steps:
                value, position = step(data, position)
                if own_name:
                    values[own_name] = value
            return cls(**values), position

        return decode

    def _value(self, field: Ros1Field, base: str, level: int) -> Decode:
        is_number = field.base in _FORMATS and field.base not in {"bool", "byte"}
        if is_number and field.size is not None:
            return _numbers(field, _FORMATS[field.base])
        decode = self._single(field, base, level)
        return decode if field.size is None else _list(decode, field.size)

    def _single(self, field: Ros1Field, base: str, level: int) -> Decode:
        if field.base == "string":
            return _text
        if field.base in _TIMES:
            return _time(*_TIMES[field.base])
        if field.base in _FORMATS:
            return _number(_FORMATS[field.base], is_byte=base == "byte")
        return self.message(field.base, base, level + 1)


def _list(decode_element: Decode, size: int) -> Decode:
    def decode(data: bytes, position: int) -> tuple[Any, int]:
        count = size
        if size < 0:
            (count,) = struct.unpack_from("<I", data, position)
            position += 4
        values = []
        for _ in range(count):
            value, end = decode_element(data, position)
            if end == position and count > 1:  # else a few bytes could mean a list of any length
                raise struct.error("the elements of a list have no bytes")
            values.append(value)
            position = end
        return values, position

    return decode


def _text(data: bytes, position: int) -> tuple[str, int]:
    (length,) = struct.unpack_from("<I", data, position)
    start, end = position + 4, position + 4 + length
    if end > len(data):
        raise struct.error("a text is longer than the message")
    return data[start:end].decode("utf-8", "replace"), end


def _time(target: str, form: str) -> Decode:
    cls: Any = get_message(ros2_name(target))

    def decode(data: bytes, position: int) -> tuple[Any, int]:
        seconds, nanoseconds = struct.unpack_from(form, data, position)
        # ROS 2's times end in 2038, and ROS 2's durations have no negative nanoseconds.
        seconds, nanoseconds = seconds + nanoseconds // 10**9, nanoseconds % 10**9
        return cls(sec=min(seconds, 2**31 - 1), nanosec=nanoseconds), position + 8

    return decode


def _number(form: str, *, is_byte: bool) -> Decode:
    packed = struct.Struct(f"<{form}")

    def decode(data: bytes, position: int) -> tuple[Any, int]:
        (value,) = packed.unpack_from(data, position)
        return (bytes((value & 255,)) if is_byte else value), position + packed.size

    return decode


def _numbers(field: Ros1Field, form: str) -> Decode:
    size, width = field.size or 0, struct.calcsize(f"<{form}")

    def decode(data: bytes, position: int) -> tuple[Any, int]:
        count = size
        if size < 0:
            (count,) = struct.unpack_from("<I", data, position)
            position += 4
        end = position + count * width
        if end > len(data):
            raise struct.error("an array is longer than the message")
        values = array(form)
        values.frombytes(data[position:end])
        return values, end

    return decode
