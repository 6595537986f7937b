# Written by python -m zbot.compat.generator; do not edit.
"""Groups that decide which callbacks may run at the same time."""

from zbot.executor.callback_group import (
    CallbackGroup,
    MutuallyExclusiveCallbackGroup,
    ReentrantCallbackGroup,
)

__all__ = [
    "CallbackGroup",
    "MutuallyExclusiveCallbackGroup",
    "ReentrantCallbackGroup",
]
