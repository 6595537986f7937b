# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `rosidl_adapter`: the part that reads .msg, .srv and .action files."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use

if TYPE_CHECKING:
    from . import parser as parser
else:
    __getattr__ = at_first_use(
        __name__,
        "parser",
    )
