# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `RegisterEventHandler`."""

from zbot.launch.actions import RegisterEventHandler

__all__ = [
    "RegisterEventHandler",
]
