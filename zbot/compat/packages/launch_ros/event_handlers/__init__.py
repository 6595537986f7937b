# Written by python -m zbot.compat.generator; do not edit.
"""Handlers that do something when a managed node changes its state."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.actions.lifecycle_node import OnStateTransition

__all__ = [
    "OnStateTransition",
]

if TYPE_CHECKING:
    from . import on_state_transition as on_state_transition
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "on_state_transition",
        ),
    )[0]
