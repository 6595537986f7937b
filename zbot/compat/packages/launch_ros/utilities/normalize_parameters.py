# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `normalize_parameters`."""

from zbot.launch.parameters import normalize_parameters

__all__ = [
    "normalize_parameters",
]
