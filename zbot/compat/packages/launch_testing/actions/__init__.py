# Written by python -m zbot.compat.generator; do not edit.
"""Actions of launch files under test."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use
from zbot.launch.actions.testing import ReadyToTest
from zbot.launch.testing.test_action import GTest, PyTest, Test

__all__ = [
    "GTest",
    "PyTest",
    "ReadyToTest",
    "Test",
]

if TYPE_CHECKING:
    from . import ready as ready
    from . import ready_to_test as ready_to_test
else:
    __getattr__ = at_first_use(
        __name__,
        "ready",
        "ready_to_test",
    )
