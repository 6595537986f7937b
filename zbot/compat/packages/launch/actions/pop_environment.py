# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `PopEnvironment`."""

from zbot.launch.actions import PopEnvironment

__all__ = [
    "PopEnvironment",
]
