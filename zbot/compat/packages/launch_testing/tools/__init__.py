"""Processes that tests start."""

from zbot.launch.testing.expected_output import expect_output as expect_output
from zbot.launch.testing.expected_output import (
    expected_output_from_file as expected_output_from_file,
)
from zbot.launch.testing.output_text import basic_output_filter as basic_output_filter
from zbot.launch.testing.output_text import (
    get_default_filtered_patterns as get_default_filtered_patterns,
)
from zbot.launch.testing.output_text import (
    get_default_filtered_prefixes as get_default_filtered_prefixes,
)
from zbot.launch.testing.tool import ProcessProxy as ProcessProxy
from zbot.launch.testing.tool import launch_process as launch_process
