# Written by python -m zbot.compat.generator; do not edit.
"""Action that marks when tests may begin."""

from zbot.launch.testing.test_action import ReadyToTest

__all__ = [
    "ReadyToTest",
]
