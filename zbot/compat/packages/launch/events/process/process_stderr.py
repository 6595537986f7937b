# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ProcessStderr`."""

from zbot.launch.process_event import ProcessStderr

__all__ = [
    "ProcessStderr",
]
