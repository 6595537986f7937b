# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ProcessTargetedEvent`."""

from zbot.launch.process_event import ProcessTargetedEvent

__all__ = [
    "ProcessTargetedEvent",
]
