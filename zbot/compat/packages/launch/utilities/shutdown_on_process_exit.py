"""Ends the launch with one of its processes."""

from zbot.launch.actions import shutdown_on_process_exit as shutdown_on_process_exit
