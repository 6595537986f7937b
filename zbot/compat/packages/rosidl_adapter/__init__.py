# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `rosidl_adapter`: the part that reads .msg, .srv and .action files."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names

if TYPE_CHECKING:
    from . import parser as parser
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "parser",
        ),
    )[0]
