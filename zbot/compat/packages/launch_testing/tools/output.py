# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `expect_output` and `expected_output_from_file` and `basic_output_filter` and `get_default_filtered_patterns` and `get_default_filtered_prefixes`."""

from zbot.launch.testing.expected_output import expect_output, expected_output_from_file
from zbot.launch.testing.output_text import (
    basic_output_filter,
    get_default_filtered_patterns,
    get_default_filtered_prefixes,
)

__all__ = [
    "basic_output_filter",
    "expect_output",
    "expected_output_from_file",
    "get_default_filtered_patterns",
    "get_default_filtered_prefixes",
]
