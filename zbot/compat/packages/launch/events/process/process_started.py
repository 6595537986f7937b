# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ProcessStarted`."""

from zbot.launch.process_event import ProcessStarted

__all__ = [
    "ProcessStarted",
]
