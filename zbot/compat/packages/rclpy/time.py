# Written by python -m zbot.compat.generator; do not edit.
"""Points in time."""

from zbot.time import ClockType, Duration, S_TO_NS, Time

__all__ = [
    "ClockType",
    "Duration",
    "S_TO_NS",
    "Time",
]
