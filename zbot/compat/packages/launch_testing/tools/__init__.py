# Written by python -m zbot.compat.generator; do not edit.
"""Processes that tests start."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.testing.expected_output import expect_output, expected_output_from_file
from zbot.launch.testing.output_text import (
    basic_output_filter,
    get_default_filtered_patterns,
    get_default_filtered_prefixes,
)
from zbot.launch.testing.tool import ProcessProxy, launch_process

__all__ = [
    "ProcessProxy",
    "basic_output_filter",
    "expect_output",
    "expected_output_from_file",
    "get_default_filtered_patterns",
    "get_default_filtered_prefixes",
    "launch_process",
]

if TYPE_CHECKING:
    from . import output as output
    from . import process as process
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "output",
            "process",
        ),
    )[0]
