# Written by python -m zbot.compat.generator; do not edit.
"""Kinds of clocks."""

from zbot.time import ClockType

__all__ = [
    "ClockType",
]
