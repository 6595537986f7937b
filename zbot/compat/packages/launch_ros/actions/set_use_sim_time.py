# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `SetUseSimTime`."""

from zbot.launch.actions import SetUseSimTime

__all__ = [
    "SetUseSimTime",
]
