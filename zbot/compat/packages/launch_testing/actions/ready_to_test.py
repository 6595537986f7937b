# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ReadyToTest`."""

from zbot.launch.actions.testing import ReadyToTest

__all__ = [
    "ReadyToTest",
]
