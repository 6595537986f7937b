# Written by python -m zbot.compat.generator; do not edit.
"""Nav2's `nav2_simple_commander`."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names

if TYPE_CHECKING:
    from . import costmap_2d as costmap_2d
    from . import footprint_collision_checker as footprint_collision_checker
    from . import line_iterator as line_iterator
    from . import occupancy_grid as occupancy_grid
    from . import robot_navigator as robot_navigator
    from . import utils as utils
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "costmap_2d",
            "footprint_collision_checker",
            "line_iterator",
            "occupancy_grid",
            "robot_navigator",
            "utils",
        ),
    )[0]
