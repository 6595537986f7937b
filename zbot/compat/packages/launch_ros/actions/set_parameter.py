# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `SetParameter`."""

from zbot.launch.actions import SetParameter

__all__ = [
    "SetParameter",
]
