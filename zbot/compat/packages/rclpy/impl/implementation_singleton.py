"""ROS 2's `rclpy.impl.implementation_singleton`, which names the C extension."""

import importlib

rclpy_implementation = importlib.import_module("rclpy._rclpy_pybind11")
