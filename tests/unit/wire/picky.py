"""A dataclass whose constructor refuses two values, for the tests of both codecs."""

from __future__ import annotations

from dataclasses import dataclass

from zbot.errors import ExternalShutdownException


@dataclass
class Picky:
    value: int = 0

    def __post_init__(self) -> None:
        if self.value == 13:
            raise KeyError("thirteen")
        if self.value == 15:
            raise ExternalShutdownException
