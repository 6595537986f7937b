# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `ros2cli`, for programs that query the graph with its node."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use

if TYPE_CHECKING:
    from . import node as node
else:
    __getattr__ = at_first_use(
        __name__,
        "node",
    )
