# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `sensor_msgs_py`."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names

if TYPE_CHECKING:
    from . import point_cloud2 as point_cloud2
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "point_cloud2",
        ),
    )[0]
