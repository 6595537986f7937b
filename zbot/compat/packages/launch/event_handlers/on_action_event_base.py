# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `OnActionEventBase`."""

from zbot.launch.event_handler import OnActionEventBase

__all__ = [
    "OnActionEventBase",
]
