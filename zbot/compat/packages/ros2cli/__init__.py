# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `ros2cli`, for programs that query the graph with its node."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names

if TYPE_CHECKING:
    from . import node as node
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "node",
        ),
    )[0]
