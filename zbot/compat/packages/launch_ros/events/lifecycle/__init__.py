# Written by python -m zbot.compat.generator; do not edit.
"""Events of managed nodes."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use
from zbot.launch.lifecycle_event import ChangeState, StateTransition, matches_node_name

__all__ = [
    "ChangeState",
    "StateTransition",
    "matches_node_name",
]

if TYPE_CHECKING:
    from . import change_state as change_state
    from . import state_transition as state_transition
else:
    __getattr__ = at_first_use(
        __name__,
        "change_state",
        "state_transition",
    )
