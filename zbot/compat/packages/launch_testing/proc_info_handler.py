# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ActiveProcInfoHandler` and `ProcInfoHandler`."""

from zbot.launch.testing.record import (
    ExitRecord as ActiveProcInfoHandler,
    ExitRecord as ProcInfoHandler,
)

__all__ = [
    "ActiveProcInfoHandler",
    "ProcInfoHandler",
]
