# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `SubstitutionFailure`."""

from zbot.launch.errors import SubstitutionError as SubstitutionFailure

__all__ = [
    "SubstitutionFailure",
]
