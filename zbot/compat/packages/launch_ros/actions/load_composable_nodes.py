# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `LoadComposableNodes`."""

from zbot.launch.actions import LoadComposableNodes

__all__ = [
    "LoadComposableNodes",
]
