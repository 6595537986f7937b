"""Messages that a thread reads in advance."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from tests.unit.bag.messages import MESSAGES, write
from zbot.bag import Reader
from zbot.bag.errors import BagReadError
from zbot.bag.message import BagMessage
from zbot.bag.read_ahead import ReadAhead

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path


def test_an_unexpected_error_ends_the_messages() -> None:
    def read() -> Iterator[BagMessage]:
        yield BagMessage("/a", b"", 1, 1)
        raise IndexError("wrong")

    messages = ReadAhead(read(), 100)
    messages.wait_until_filled(10)
    with pytest.raises(IndexError, match="wrong"):
        list(messages)
    messages.close()


def test_a_file_that_is_removed_during_the_playback_is_told(path: Path) -> None:
    write(path, MESSAGES, max_bytes=1)
    with Reader(path) as bag:
        (path / "lesson_1.mcap").unlink()
        messages = ReadAhead(bag.messages(), 100)
        found = iter(messages)
        assert next(found).topic == "/string"
        with pytest.raises(BagReadError, match=r"lesson_1.mcap': No such file"):
            list(found)
        messages.close()
