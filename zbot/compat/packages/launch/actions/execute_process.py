# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ExecuteProcess`."""

from zbot.launch.actions import ExecuteProcess

__all__ = [
    "ExecuteProcess",
]
