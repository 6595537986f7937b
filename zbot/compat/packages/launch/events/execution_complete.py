# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ExecutionComplete`."""

from zbot.launch.event import ExecutionComplete

__all__ = [
    "ExecutionComplete",
]
