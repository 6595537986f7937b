# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `Executable`."""

from zbot.launch.actions.executable import Executable

__all__ = [
    "Executable",
]
