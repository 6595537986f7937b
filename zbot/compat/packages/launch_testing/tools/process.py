"""Processes that tests start."""

from zbot.launch.testing.tool import ProcessProxy as ProcessProxy
from zbot.launch.testing.tool import launch_process as launch_process
