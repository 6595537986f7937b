# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `rclpy.waitable`: every name is zbot's."""

from zbot.executor.waitable import NumberOfEntities, Waitable

__all__ = [
    "NumberOfEntities",
    "Waitable",
]
