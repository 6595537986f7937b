# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `laser_geometry`: laser scans as point clouds."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.libraries.laser_projection import LaserProjection

__all__ = [
    "LaserProjection",
]

if TYPE_CHECKING:
    from . import laser_geometry as laser_geometry
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "laser_geometry",
        ),
    )[0]
