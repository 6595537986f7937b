# Written by python -m zbot.compat.generator; do not edit.
"""Events of nodes."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.actions.lifecycle_node import matches_node_name

__all__ = [
    "matches_node_name",
]

if TYPE_CHECKING:
    from . import lifecycle as lifecycle
    from . import matchers as matchers
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "lifecycle",
            "matchers",
        ),
    )[0]
