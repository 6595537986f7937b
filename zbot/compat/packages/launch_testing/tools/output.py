"""Tools for outputs of processes."""

from zbot.launch.testing.expected_output import (
    expect_output,
    expected_output_from_file,
)
from zbot.launch.testing.output_text import (
    basic_output_filter,
    get_default_filtered_patterns,
    get_default_filtered_prefixes,
)
