# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ProcessExited`."""

from zbot.launch.process_event import ProcessExited

__all__ = [
    "ProcessExited",
]
