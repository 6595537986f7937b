"""Two classes of one type: zbot's class, and the class of an installed ROS 2."""

from __future__ import annotations

from typing import Any


def is_message_of(value: object, cls: type[Any]) -> bool:
    """Return whether a value is a message of a class, or of another class of the same type."""
    return isinstance(value, cls) or is_same_type(type(value), cls)


def is_same_type(other: type[Any], cls: type[Any]) -> bool:
    """Return whether two classes of messages have the same type name and the same fields.

    The name is that of the class and its module, e.g. `Header` in `std_msgs.msg._header`.
    """
    if (other.__module__, other.__name__) != (cls.__module__, cls.__name__):
        return False
    return _fields(other) == _fields(cls)


def _fields(cls: Any) -> dict[str, str] | None:
    read = getattr(cls, "get_fields_and_field_types", None)
    return read() if read else None
