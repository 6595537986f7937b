"""`FrontendLaunchDescriptionSource` under its own module's name."""

from zbot.launch.source import FrontendLaunchDescriptionSource
