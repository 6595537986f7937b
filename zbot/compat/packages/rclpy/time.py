"""Points in time."""

from zbot.time import S_TO_NS, ClockType, Duration, Time
