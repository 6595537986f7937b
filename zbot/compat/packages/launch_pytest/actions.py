# Written by python -m zbot.compat.generator; do not edit.
"""Action that marks when tests may begin."""

from zbot.launch.actions.testing import ReadyToTest

__all__ = [
    "ReadyToTest",
]
