# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `Parameter`."""

from zbot.launch.substitutions import Parameter

__all__ = [
    "Parameter",
]
