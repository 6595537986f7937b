# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `OnProcessIO`."""

from zbot.launch.event_handler import OnProcessIO

__all__ = [
    "OnProcessIO",
]
