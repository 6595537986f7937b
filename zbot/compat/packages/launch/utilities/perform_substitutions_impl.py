# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `perform_substitutions`."""

from zbot.launch.substitution import perform as perform_substitutions

__all__ = [
    "perform_substitutions",
]
