"""Error of an invalid launch file."""

from zbot.launch.errors import InvalidLaunchFileError
