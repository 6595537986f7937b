# Written by python -m zbot.compat.generator; do not edit.
"""Runner of the launches of a test file and of their tests."""

from zbot.launch.testing.test_runner import LaunchTestRunner

__all__ = [
    "LaunchTestRunner",
]
