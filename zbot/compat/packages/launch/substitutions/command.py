# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `Command`."""

from zbot.launch.substitutions import Command

__all__ = [
    "Command",
]
