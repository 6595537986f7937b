# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `message_filters`: messages that belong together."""

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
    "SimpleFilter",
    "Subscriber",
    "TimeSynchronizer",
]
