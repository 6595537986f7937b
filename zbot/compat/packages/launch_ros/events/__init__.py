# Written by python -m zbot.compat.generator; do not edit.
"""Events of nodes."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use
from zbot.launch.lifecycle_event import matches_node_name

__all__ = [
    "matches_node_name",
]

if TYPE_CHECKING:
    from . import lifecycle as lifecycle
    from . import matchers as matchers
else:
    __getattr__ = at_first_use(
        __name__,
        "lifecycle",
        "matchers",
    )
