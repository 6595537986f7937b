# Written by python -m zbot.compat.generator; do not edit.
"""Types of arguments that contain a node's parameters."""

from zbot.launch.parameters import SomeParameters

__all__ = [
    "SomeParameters",
]
