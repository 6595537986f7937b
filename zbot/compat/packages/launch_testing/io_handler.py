# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ActiveIoHandler` and `IoHandler`."""

from zbot.launch.testing.record import OutputRecord as ActiveIoHandler, OutputRecord as IoHandler

__all__ = [
    "ActiveIoHandler",
    "IoHandler",
]
