"""Maps."""

from zbot.libraries.navigation.costmap import PyOccupancyGrid
