# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `TransformBroadcaster`."""

from zbot.tf2.broadcaster import TransformBroadcaster

__all__ = [
    "TransformBroadcaster",
]
