# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `LaserProjection`."""

from zbot.libraries.laser_projection import LaserProjection

__all__ = [
    "LaserProjection",
]
