"""Types of topics: those that the user gives, and those that the first value of a topic decides."""

from __future__ import annotations

import re
from dataclasses import dataclass
from fnmatch import fnmatchcase
from pathlib import Path
from typing import TYPE_CHECKING, Any

from zbot.bridge.devices.errors import DeviceError
from zbot.errors.suggestion import did_you_mean
from zbot.interfaces import get_message, interface_names
from zbot.interfaces.errors import UnknownInterfaceError, UnknownPackageError
from zbot.interfaces.field_path import FieldPath, FieldPathError
from zbot.interfaces.slot import slots_of
from zbot.interfaces.yaml_message import Word
from zbot.text.yaml_reader import YamlError, read_yaml

if TYPE_CHECKING:
    from collections.abc import Iterable

_TYPE = re.compile(
    r"(?:(?P<package>\w+)/)?(?:msg/)?(?P<name>\w+)(?:\.(?P<field>[\w.]+))?\Z", re.ASCII
)
_INT32, _INT64 = 2**31, 2**63
_EXAMPLE = "temperature:Float32 or /imu:sensor_msgs/msg/Imu"


@dataclass(frozen=True)
class TopicType:
    """Type of a topic, and the field that a single value is for."""

    name: str  #: full name, e.g. `std_msgs/msg/Float32`
    field: str = ""  #: path of a field, e.g. `linear.x`; empty if a value is for the whole message

    @classmethod
    def parse(cls, text: str) -> TopicType:
        """Return the type in a text: `Float32`, `sensor_msgs/msg/Temperature.temperature`.

        A name without a package is one of std_msgs. Types with one field need no field.

        Raises:
            DeviceError: There is no such type or no such field.
        """
        match = _TYPE.match(text.strip())
        if match is None:
            raise DeviceError(f"{text!r} is not a type: write for example std_msgs/msg/Float32")
        name = f"{match['package'] or 'std_msgs'}/msg/{match['name']}"
        message_type = _known(name, text)
        field = match["field"] or only_field(message_type)
        try:
            if field:
                FieldPath(field).check(message_type)
        except FieldPathError as error:
            raise DeviceError(f"{name}: {error}", hint=error.hint) from None
        return cls(name, field)

    @property
    def message_type(self) -> type[Any]:
        """The class of the messages."""
        return get_message(self.name)

    def __str__(self) -> str:
        return self.name


def _known(name: str, text: str) -> type[Any]:
    try:
        return get_message(name)
    except (UnknownPackageError, UnknownInterfaceError, LookupError) as error:
        known = [found.rpartition("/")[2] for found in interface_names("std_msgs")]
        hint = did_you_mean(text.rpartition("/")[2], known)
        hint = hint or "`zbot interface list` shows all types"
        raise DeviceError(f"there is no type {name}", hint=hint) from error


def only_field(message_type: type[Any]) -> str:
    """Return the name of the only field of a type if a single value fits it, or an empty string."""
    slots = list(slots_of(message_type).values())
    is_single = len(slots) == 1 and not slots[0].is_list and not slots[0].is_message
    return slots[0].name if is_single else ""


def type_of_value(value: Any) -> TopicType | None:
    """Return the type that the first value of a topic decides, or None if no type fits.

    Args:
        value: A word, or a list of numbers.
    """
    if isinstance(value, list):
        if not value or any(type(item) not in {int, float} for item in value):
            return None
        is_whole = all(type(item) is int and -_INT32 <= item < _INT32 for item in value)
        return TopicType(f"std_msgs/msg/{'Int32' if is_whole else 'Float32'}MultiArray")
    name = _scalar_type(value.value) if isinstance(value, Word) else None
    return TopicType(f"std_msgs/msg/{name}", "data") if name else None


def _scalar_type(value: object) -> str | None:
    if isinstance(value, bool):
        return "Bool"
    if isinstance(value, int):
        if -_INT32 <= value < _INT32:
            return "Int32"
        return "Int64" if -_INT64 <= value < _INT64 else "Float64"
    if isinstance(value, float):
        return "Float32"
    return "String" if isinstance(value, str) else None


class TypeTable:
    """Types that the user gives for topics, by name or pattern. The first that fits is used.

    Args:
        entries: Patterns of names and their types.
    """

    def __init__(self, entries: Iterable[tuple[str, TopicType]] = ()) -> None:
        self._entries = [(pattern.lstrip("/"), kind) for pattern, kind in entries]

    @classmethod
    def read(cls, texts: Iterable[str], file: str = "") -> TypeTable:
        """Return the types of options such as `temperature:Float32`, and of a YAML file.

        Raises:
            DeviceError: An option is not valid, or the file cannot be read.
        """
        entries = [_entry(text) for text in texts]
        return cls([*entries, *(read_types(Path(file)) if file else ())])

    def find(self, name: str) -> TopicType | None:
        """Return the type of a topic, or None. A first `/` in the name does not count."""
        name = name.lstrip("/")
        return next((kind for text, kind in self._entries if fnmatchcase(name, text)), None)


def _entry(text: str) -> tuple[str, TopicType]:
    name, colon, kind = text.partition(":")
    if not colon or not name:
        raise DeviceError(f"{text!r} is not a topic and its type: write {_EXAMPLE}")
    return name, TopicType.parse(kind)


def read_types(file: Path) -> list[tuple[str, TopicType]]:
    """Return the topics and types in a YAML file: one line `temperature: Float32` for each topic.

    Raises:
        DeviceError: The file cannot be read, or a type does not exist.
    """
    try:
        values = read_yaml(file.read_text(encoding="utf-8"), as_strings=True)
    except (OSError, UnicodeDecodeError, YamlError) as error:
        raise DeviceError(
            f"cannot read {file}: {getattr(error, 'strerror', None) or error}"
        ) from None
    if not isinstance(values, dict) or not all(
        isinstance(part, str) for item in values.items() for part in item
    ):
        raise DeviceError(
            f"{file}: write one line for each topic: temperature: std_msgs/msg/Float32"
        )
    return [(name, TopicType.parse(kind)) for name, kind in values.items()]
