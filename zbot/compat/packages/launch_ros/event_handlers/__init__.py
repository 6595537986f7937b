# Written by python -m zbot.compat.generator; do not edit.
"""Handlers that do something when a managed node changes its state."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use
from zbot.launch.lifecycle_event import OnStateTransition

__all__ = [
    "OnStateTransition",
]

if TYPE_CHECKING:
    from . import on_state_transition as on_state_transition
else:
    __getattr__ = at_first_use(
        __name__,
        "on_state_transition",
    )
