# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ProcessStdout`."""

from zbot.launch.process_event import ProcessStdout

__all__ = [
    "ProcessStdout",
]
