# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `OpaqueCoroutine`."""

from zbot.launch.actions import OpaqueCoroutine

__all__ = [
    "OpaqueCoroutine",
]
