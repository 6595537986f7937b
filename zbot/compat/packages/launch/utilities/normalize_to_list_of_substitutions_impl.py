# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `normalize_to_list_of_substitutions`."""

from zbot.launch.substitution import normalize as normalize_to_list_of_substitutions

__all__ = [
    "normalize_to_list_of_substitutions",
]
