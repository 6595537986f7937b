# Written by python -m zbot.compat.generator; do not edit.
"""Launch files in YAML as sources."""

from zbot.launch.source import YAMLLaunchDescriptionSource

__all__ = [
    "YAMLLaunchDescriptionSource",
]
