# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ProcessProxy` and `launch_process`."""

from zbot.launch.testing.tool import ProcessProxy, launch_process

__all__ = [
    "ProcessProxy",
    "launch_process",
]
