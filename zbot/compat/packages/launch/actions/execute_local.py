# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ExecuteLocal`."""

from zbot.launch.actions import ExecuteLocal

__all__ = [
    "ExecuteLocal",
]
