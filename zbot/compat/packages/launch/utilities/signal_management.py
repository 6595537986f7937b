# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `AsyncSafeSignalManager`."""

from zbot.launch.signal_manager import AsyncSafeSignalManager

__all__ = [
    "AsyncSafeSignalManager",
]
