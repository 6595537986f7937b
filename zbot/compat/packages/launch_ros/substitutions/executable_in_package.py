# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ExecutableInPackage`."""

from zbot.launch.substitutions import ExecutableInPackage

__all__ = [
    "ExecutableInPackage",
]
