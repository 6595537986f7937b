"""Costs of a robot's outline."""

from zbot.libraries.navigation.costmap import (
    FREE_SPACE,
    INSCRIBED_INFLATED_OBSTACLE,
    LETHAL_OBSTACLE,
    MAX_NON_OBSTACLE,
    NO_INFORMATION,
    FootprintCollisionChecker,
    LineIterator,
    PyCostmap2D,
)
