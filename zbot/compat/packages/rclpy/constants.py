"""Numbers."""

from zbot.time import S_TO_NS as S_TO_NS
