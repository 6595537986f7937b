# Written by python -m zbot.compat.generator; do not edit.
"""Actions of `launch_testing`."""

from zbot.launch.testing.test_action import ReadyToTest

__all__ = [
    "ReadyToTest",
]
