# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `message_filters`: messages that belong together."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.libraries.message_filter import (
    ApproximateTimeSynchronizer,
    Cache,
    Chain,
    SimpleFilter,
    Subscriber,
    TimeSynchronizer,
)

__all__ = [
    "ApproximateTimeSynchronizer",
    "Cache",
    "Chain",
    "Duration",
    "LoggingSeverity",
    "ROSClock",
    "SimpleFilter",
    "Subscriber",
    "Time",
    "TimeSynchronizer",
]

if TYPE_CHECKING:
    from zbot.executor.clock import ROSClock as ROSClock
    from zbot.log import LoggingSeverity as LoggingSeverity
    from zbot.time import Duration as Duration
    from zbot.time import Time as Time
else:
    __getattr__ = lazy_names(
        __name__,
        {
            "zbot.executor.clock": "ROSClock",
            "zbot.log": "LoggingSeverity",
            "zbot.time": "Duration Time",
        },
        submodules=(
        ),
    )[0]
