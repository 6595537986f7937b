# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `rosidl_parser`: the part that describes types of fields."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use

if TYPE_CHECKING:
    from . import definition as definition
else:
    __getattr__ = at_first_use(
        __name__,
        "definition",
    )
