# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `Substitution`."""

from zbot.launch import Substitution

__all__ = [
    "Substitution",
]
