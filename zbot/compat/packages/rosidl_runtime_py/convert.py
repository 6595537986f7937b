# Written by python -m zbot.compat.generator; do not edit.
"""Functions that convert messages to strings and dictionaries."""

from zbot.compat.rosidl.conversion import (
    convert_value as _convert_value,
    get_message_slot_types,
    message_to_csv,
    message_to_ordereddict,
    message_to_yaml,
)

__all__ = [
    "get_message_slot_types",
    "message_to_csv",
    "message_to_ordereddict",
    "message_to_yaml",
]
