"""`IncludeLaunchDescription` under its own module's name."""

from zbot.launch.event import IncludeLaunchDescriptionEvent as IncludeLaunchDescription

__all__ = ["IncludeLaunchDescription"]
