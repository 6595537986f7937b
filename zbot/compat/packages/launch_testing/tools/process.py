"""Processes that tests start."""

from zbot.launch_test.tool import ProcessProxy as ProcessProxy
from zbot.launch_test.tool import launch_process as launch_process
