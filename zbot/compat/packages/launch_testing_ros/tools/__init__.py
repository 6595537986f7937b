# Written by python -m zbot.compat.generator; do not edit.
"""Tools for outputs of nodes."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.testing.output_text import ros_output_filter as basic_output_filter

__all__ = [
    "basic_output_filter",
]

if TYPE_CHECKING:
    from . import output as output
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "output",
        ),
    )[0]
