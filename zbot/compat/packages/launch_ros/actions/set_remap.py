# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `SetRemap`."""

from zbot.launch.actions import SetRemap

__all__ = [
    "SetRemap",
]
