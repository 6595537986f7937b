# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `OnExecutionComplete`."""

from zbot.launch.event_handler import OnExecutionComplete

__all__ = [
    "OnExecutionComplete",
]
