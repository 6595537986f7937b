# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `SignalProcess`."""

from zbot.launch.process_event import SignalProcess

__all__ = [
    "SignalProcess",
]
