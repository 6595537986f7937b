# Written by python -m zbot.compat.generator; do not edit.
"""Maps."""

from zbot.libraries.navigation.costmap import PyOccupancyGrid

__all__ = [
    "PyOccupancyGrid",
]
