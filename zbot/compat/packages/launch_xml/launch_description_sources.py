# Written by python -m zbot.compat.generator; do not edit.
"""Launch files in XML as sources."""

from zbot.launch.source import XMLLaunchDescriptionSource

__all__ = [
    "XMLLaunchDescriptionSource",
]
