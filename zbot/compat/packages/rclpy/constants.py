"""Numbers."""

from zbot.time import S_TO_NS
