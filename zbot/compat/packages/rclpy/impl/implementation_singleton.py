# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `rclpy.impl.implementation_singleton`, which names the C extension."""

from .. import _rclpy_pybind11 as rclpy_implementation

__all__ = [
    "rclpy_implementation",
]
