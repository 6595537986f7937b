# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `Log`."""

from zbot.launch.actions import Log

__all__ = [
    "Log",
]
