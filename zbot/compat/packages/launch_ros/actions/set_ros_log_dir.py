# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `SetROSLogDir`."""

from zbot.launch.actions import SetROSLogDir

__all__ = [
    "SetROSLogDir",
]
