# Written by python -m zbot.compat.generator; do not edit.
"""Lines."""

from zbot.libraries.navigation.costmap import LineIterator

__all__ = [
    "LineIterator",
]
