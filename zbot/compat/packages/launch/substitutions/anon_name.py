# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `AnonName`."""

from zbot.launch.substitutions import AnonName

__all__ = [
    "AnonName",
]
