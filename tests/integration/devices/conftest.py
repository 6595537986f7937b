"""Fixtures of tests with boards and brokers."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from tests.pseudo_board import PseudoBoard


@pytest.fixture
def plug_in(tmp_path: Path) -> Iterator[Callable[[str], PseudoBoard]]:
    """Return a function that makes a board. Its port is a file with the given name."""
    if sys.platform == "win32":
        pytest.skip("Windows has no pseudo-terminals")
    from tests.pseudo_board import PseudoBoard  # noqa: PLC0415 - as above

    boards: list[PseudoBoard] = []

    def make(name: str) -> PseudoBoard:
        boards.append(PseudoBoard(tmp_path / name))
        return boards[-1]

    yield make
    for board in boards:
        board.unplug()
