"""Launch files in YAML as sources."""

from zbot.launch.source import YAMLLaunchDescriptionSource
