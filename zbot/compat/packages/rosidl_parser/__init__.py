# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `rosidl_parser`: the part that describes types of fields."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names

if TYPE_CHECKING:
    from . import definition as definition
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "definition",
        ),
    )[0]
