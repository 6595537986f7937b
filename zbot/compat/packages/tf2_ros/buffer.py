# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `Buffer`."""

from zbot.tf2.buffer import Buffer

__all__ = [
    "Buffer",
]
