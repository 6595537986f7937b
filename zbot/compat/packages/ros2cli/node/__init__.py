# Written by python -m zbot.compat.generator; do not edit.
"""Nodes that query the graph."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names

if TYPE_CHECKING:
    from . import direct as direct
    from . import strategy as strategy
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "direct",
            "strategy",
        ),
    )[0]
