# Written by python -m zbot.compat.generator; do not edit.
"""Decorators for the functions of test files."""

from zbot.launch.testing.marker import keep_alive, retry_on_failure

__all__ = [
    "keep_alive",
    "retry_on_failure",
]
