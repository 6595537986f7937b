"""Durations."""

from zbot.time import S_TO_NS as S_TO_NS
from zbot.time import Duration as Duration
from zbot.time import Infinite as Infinite
