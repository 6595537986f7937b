# Written by python -m zbot.compat.generator; do not edit.
"""Nodes that query the graph."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use

if TYPE_CHECKING:
    from . import direct as direct
    from . import strategy as strategy
else:
    __getattr__ = at_first_use(
        __name__,
        "direct",
        "strategy",
    )
