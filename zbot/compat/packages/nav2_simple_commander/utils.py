# Written by python -m zbot.compat.generator; do not edit.
"""Rotations. The functions that kill processes by name are left out."""

from zbot.libraries.navigation.costmap import euler_to_quaternion

__all__ = [
    "euler_to_quaternion",
]
