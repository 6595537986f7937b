# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ProcessStdin`."""

from zbot.launch.process_event import ProcessStdin

__all__ = [
    "ProcessStdin",
]
