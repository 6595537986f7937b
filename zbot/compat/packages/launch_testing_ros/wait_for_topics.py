# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `WaitForTopics`."""

from zbot.launch.testing.topics import WaitForTopics

__all__ = [
    "WaitForTopics",
]
