# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `EventsExecutor`."""

from zbot.executor.single_threaded_executor import SingleThreadedExecutor as EventsExecutor

__all__ = [
    "EventsExecutor",
]
