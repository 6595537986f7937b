# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `rclpy.experimental`: zbot's own executor is driven by events."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.executor.single_threaded_executor import SingleThreadedExecutor as EventsExecutor

__all__ = [
    "EventsExecutor",
]

if TYPE_CHECKING:
    from . import events_executor as events_executor
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "events_executor",
        ),
    )[0]
