# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `matches_executable` and `matches_name` and `matches_pid`."""

from zbot.launch.process_event import matches_executable, matches_name, matches_pid

__all__ = [
    "matches_executable",
    "matches_name",
    "matches_pid",
]
