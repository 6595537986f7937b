# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `Action`."""

from zbot.launch import Action

__all__ = [
    "Action",
]
