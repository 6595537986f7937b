"""What a launch file that makes no sense raises."""

from zbot.launch.errors import InvalidLaunchFileError as InvalidLaunchFileError
