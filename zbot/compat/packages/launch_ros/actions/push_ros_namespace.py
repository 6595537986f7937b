# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `PushRosNamespace`."""

from zbot.launch.actions import PushRosNamespace

__all__ = [
    "PushRosNamespace",
]
