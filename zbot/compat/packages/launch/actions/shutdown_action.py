# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `Shutdown`."""

from zbot.launch.actions import Shutdown

__all__ = [
    "Shutdown",
]
