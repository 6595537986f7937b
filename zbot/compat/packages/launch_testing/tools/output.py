"""Outputs."""

from zbot.launch_test.output_text import basic_output_filter as basic_output_filter
from zbot.launch_test.output_text import expect_output as expect_output
