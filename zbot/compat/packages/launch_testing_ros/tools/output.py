"""Tools for outputs of nodes."""

from zbot.launch.testing.output_text import ros_output_filter as basic_output_filter

__all__ = ["basic_output_filter"]
