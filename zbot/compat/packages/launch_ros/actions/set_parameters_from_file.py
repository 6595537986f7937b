# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `SetParametersFromFile`."""

from zbot.launch.actions import SetParametersFromFile

__all__ = [
    "SetParametersFromFile",
]
