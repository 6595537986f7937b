# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `basic_output_filter`."""

from zbot.launch.testing.output_text import ros_output_filter as basic_output_filter

__all__ = [
    "basic_output_filter",
]
