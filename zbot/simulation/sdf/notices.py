"""Notices of what is left out of a world or a model."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

#: Nobody reads more. A file can name thousands of things that the simulator does not have.
_MOST = 300


def add_notices(known: list[str], new: Iterable[str]) -> None:
    """Add notices to a list, once each."""
    for text in new:
        if len(known) < _MOST and text not in known:
            known.append(text)
