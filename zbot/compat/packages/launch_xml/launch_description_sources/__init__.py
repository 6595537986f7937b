"""Launch files in XML as sources."""

from zbot.launch.source import XMLLaunchDescriptionSource
