# Written by python -m zbot.compat.generator; do not edit.
"""Durations."""

from zbot.time import Duration, Infinite, S_TO_NS

__all__ = [
    "Duration",
    "Infinite",
    "S_TO_NS",
]
