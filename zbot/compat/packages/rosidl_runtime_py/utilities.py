# Written by python -m zbot.compat.generator; do not edit.
"""Functions that find a class by its name."""

from zbot.compat.rosidl.lookup import (
    get_action,
    get_interface,
    get_message,
    get_service,
    is_action,
    is_message,
    is_service,
)

__all__ = [
    "get_action",
    "get_interface",
    "get_message",
    "get_service",
    "is_action",
    "is_message",
    "is_service",
]
