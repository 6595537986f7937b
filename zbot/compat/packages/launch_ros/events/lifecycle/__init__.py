# Written by python -m zbot.compat.generator; do not edit.
"""Events of managed nodes."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.actions.lifecycle_node import ChangeState, StateTransition, matches_node_name

__all__ = [
    "ChangeState",
    "StateTransition",
    "matches_node_name",
]

if TYPE_CHECKING:
    from . import change_state as change_state
    from . import state_transition as state_transition
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "change_state",
            "state_transition",
        ),
    )[0]
