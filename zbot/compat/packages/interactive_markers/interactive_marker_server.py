# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `InteractiveMarkerServer`."""

from zbot.libraries.interactive_markers import InteractiveMarkerServer

__all__ = [
    "InteractiveMarkerServer",
]
