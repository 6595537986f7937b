"""ROS 2's `rclpy.impl.implementation_singleton`: the module that stands for the C extension."""

import importlib

rclpy_implementation = importlib.import_module("rclpy._rclpy_pybind11")
