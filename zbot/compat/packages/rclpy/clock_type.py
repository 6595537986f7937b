"""Kinds of clocks."""

from zbot.time import ClockType
