# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `Parser`."""

from zbot.launch.frontend.parser import Parser

__all__ = [
    "Parser",
]
