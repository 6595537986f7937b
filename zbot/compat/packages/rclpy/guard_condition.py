# Written by python -m zbot.compat.generator; do not edit.
"""Guard conditions."""

from zbot.context import Context, get_default_context
from zbot.executor.callback_group import CallbackGroup
from zbot.executor.guard_condition import GuardCondition

__all__ = [
    "CallbackGroup",
    "Context",
    "GuardCondition",
    "get_default_context",
]
