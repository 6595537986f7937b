# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `StaticTransformBroadcaster`."""

from zbot.tf2.broadcaster import StaticTransformBroadcaster

__all__ = [
    "StaticTransformBroadcaster",
]
