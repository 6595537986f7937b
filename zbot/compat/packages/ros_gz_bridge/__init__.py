# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `ros_gz_bridge`: the bridge of Gazebo as an action of a launch file."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names

if TYPE_CHECKING:
    from . import actions as actions
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "actions",
        ),
    )[0]
