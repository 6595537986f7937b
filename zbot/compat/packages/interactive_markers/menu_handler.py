# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `MenuHandler`."""

from zbot.libraries.interactive_markers import MenuHandler

__all__ = [
    "MenuHandler",
]
