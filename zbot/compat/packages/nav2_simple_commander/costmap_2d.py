# Written by python -m zbot.compat.generator; do not edit.
"""Costmaps."""

from zbot.libraries.navigation.costmap import PyCostmap2D

__all__ = [
    "PyCostmap2D",
]
