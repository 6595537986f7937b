# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `sensor_msgs_py`."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use

if TYPE_CHECKING:
    from . import point_cloud2 as point_cloud2
else:
    __getattr__ = at_first_use(
        __name__,
        "point_cloud2",
    )
