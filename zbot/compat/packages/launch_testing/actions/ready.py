# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ReadyToTest`."""

from zbot.launch.testing.test_action import ReadyToTest

__all__ = [
    "ReadyToTest",
]
