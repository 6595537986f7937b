# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `AllSubstitution` and `AndSubstitution` and `AnySubstitution` and `NotSubstitution` and `OrSubstitution`."""

from zbot.launch.substitutions import (
    AllSubstitution,
    AndSubstitution,
    AnySubstitution,
    NotSubstitution,
    OrSubstitution,
)

__all__ = [
    "AllSubstitution",
    "AndSubstitution",
    "AnySubstitution",
    "NotSubstitution",
    "OrSubstitution",
]
