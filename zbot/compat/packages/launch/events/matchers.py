# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `matches_action`."""

from zbot.launch.process_event import matches_action

__all__ = [
    "matches_action",
]
