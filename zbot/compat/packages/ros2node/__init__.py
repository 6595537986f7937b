# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `ros2node`, for programs that ask the graph for its nodes."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use

if TYPE_CHECKING:
    from . import api as api
else:
    __getattr__ = at_first_use(
        __name__,
        "api",
    )
