# Written by python -m zbot.compat.generator; do not edit.
"""Actions of `launch_testing`."""

from zbot.launch.actions.testing import ReadyToTest

__all__ = [
    "ReadyToTest",
]
