"""Function that ends the launch when a process ends."""

from zbot.launch.actions import shutdown_on_process_exit
