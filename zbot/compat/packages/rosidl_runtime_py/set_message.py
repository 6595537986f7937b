# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `set_message_fields`."""

from zbot.interfaces.set_fields import set_message_fields

__all__ = [
    "set_message_fields",
]
