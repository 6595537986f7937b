"""Processes that tests start."""

from zbot.launch.testing.tool import ProcessProxy, launch_process
