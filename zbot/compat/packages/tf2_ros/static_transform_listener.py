# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `StaticTransformListener`."""

from zbot.tf2.listener import StaticTransformListener

__all__ = [
    "StaticTransformListener",
]
