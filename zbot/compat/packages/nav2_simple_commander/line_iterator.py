"""Lines."""

from zbot.libraries.navigation.costmap import LineIterator
