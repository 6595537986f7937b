# Written by python -m zbot.compat.generator; do not edit.
"""Futures and tasks."""

from zbot.executor.task import Future, FutureState, Task

__all__ = [
    "Future",
    "FutureState",
    "Task",
]
