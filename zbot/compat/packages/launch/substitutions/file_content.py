# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `FileContent`."""

from zbot.launch.substitutions import FileContent

__all__ = [
    "FileContent",
]
