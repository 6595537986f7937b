# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `Context`."""

from zbot.context import Context

__all__ = [
    "Context",
]
