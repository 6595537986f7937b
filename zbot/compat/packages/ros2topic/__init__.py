# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `ros2topic`, for programs that ask the graph for its topics."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names

if TYPE_CHECKING:
    from . import api as api
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "api",
        ),
    )[0]
