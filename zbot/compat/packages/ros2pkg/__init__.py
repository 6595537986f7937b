# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `ros2pkg`, for programs that search packages."""

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
