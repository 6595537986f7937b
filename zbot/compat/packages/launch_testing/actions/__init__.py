# Written by python -m zbot.compat.generator; do not edit.
"""Actions of launch files under test."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.testing.test_action import GTest, PyTest, ReadyToTest, Test

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
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "ready",
            "ready_to_test",
        ),
    )[0]
