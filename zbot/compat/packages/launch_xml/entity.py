# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `Entity`."""

from zbot.launch.frontend.xml_file import Entity

__all__ = [
    "Entity",
]
