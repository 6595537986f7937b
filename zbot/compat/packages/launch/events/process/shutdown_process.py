# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ShutdownProcess`."""

from zbot.launch.process_event import ShutdownProcess

__all__ = [
    "ShutdownProcess",
]
