# Written by python -m zbot.compat.generator; do not edit.
"""Costs of a robot's outline."""

from zbot.libraries.navigation.costmap import (
    FREE_SPACE,
    FootprintCollisionChecker,
    INSCRIBED_INFLATED_OBSTACLE,
    LETHAL_OBSTACLE,
    LineIterator,
    MAX_NON_OBSTACLE,
    NO_INFORMATION,
    PyCostmap2D,
)

__all__ = [
    "FREE_SPACE",
    "FootprintCollisionChecker",
    "INSCRIBED_INFLATED_OBSTACLE",
    "LETHAL_OBSTACLE",
    "LineIterator",
    "MAX_NON_OBSTACLE",
    "NO_INFORMATION",
    "PyCostmap2D",
]
