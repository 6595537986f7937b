"""Processes that tests start."""

from zbot.launch_test.output_text import basic_output_filter as basic_output_filter
from zbot.launch_test.output_text import expect_output as expect_output
from zbot.launch_test.tool import ProcessProxy as ProcessProxy
from zbot.launch_test.tool import launch_process as launch_process
