# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ResetEnvironment`."""

from zbot.launch.actions import ResetEnvironment

__all__ = [
    "ResetEnvironment",
]
