# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `EmitEvent`."""

from zbot.launch.actions import EmitEvent

__all__ = [
    "EmitEvent",
]
