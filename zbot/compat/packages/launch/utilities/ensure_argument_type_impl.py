# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ensure_argument_type`."""

from zbot.compat.launch_utilities import ensure_argument_type

__all__ = [
    "ensure_argument_type",
]
