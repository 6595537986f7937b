"""Advice for a field that a message does not have: `twist.linear.vx = 1.0`, `print(message.text)`.

Python raises an AttributeError, which does not say which fields there are. Message classes have no
`__setattr__` and no `__getattr__` of their own, because such methods would make the use of all
fields slower.
"""

from __future__ import annotations

import re
from typing import Any

from zbot.errors.suggestion import did_you_mean
from zbot.interfaces import registry

# Python 3.13 adds "and no __dict__ for setting new attributes".
_TEXT = re.compile(
    r"'(\w+)' object has no attribute '([a-zA-Z]\w*)'"
    r"(?: and no __dict__ for setting new attributes)?\Z"
)


def add_advice(error: BaseException) -> None:
    """Add the message's fields to the text of an error, if the error is about an unknown field."""
    if not isinstance(error, AttributeError):
        return
    match = _TEXT.match(str(error))
    # Another class may have the name of a message class, e.g. `rclpy.time.Time`.
    is_other = error.obj is not None and not hasattr(error.obj, "get_fields_and_field_types")
    fields = _fields_of(match[1]) if match and not is_other else ()
    if match and fields:
        hint = did_you_mean(match[2], fields) or f"it has {', '.join(fields)}"
        error.args = (f"{error}; {hint}",)
        error.obj = None  # Python would suggest a name too


def _fields_of(name: str) -> tuple[str, ...]:
    """Return the fields of the message class with this name, if there is only one such class."""
    found: list[Any] = [cls for cls in registry.used_classes() if cls.__name__ == name]
    if len(found) != 1 or not hasattr(found[0], "get_fields_and_field_types"):
        return ()
    return tuple(found[0].get_fields_and_field_types())
