# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `OnProcessExit`."""

from zbot.launch.event_handler import OnProcessExit

__all__ = [
    "OnProcessExit",
]
