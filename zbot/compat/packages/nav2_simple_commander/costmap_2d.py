"""Costmaps."""

from zbot.libraries.navigation.costmap import PyCostmap2D
