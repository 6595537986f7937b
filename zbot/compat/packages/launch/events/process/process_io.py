# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ProcessIO`."""

from zbot.launch.process_event import ProcessIO

__all__ = [
    "ProcessIO",
]
