"""Checks of the numbers of messages, and limits of what is drawn."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.view.errors import DisplayError

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import NDArray

#: Far enough for a robot. The graphics card would show nothing of a scene with larger numbers.
FARTHEST_M = 1e6


def usable(positions: NDArray[Any]) -> NDArray[np.bool_]:
    """Return which rows of an array have only finite numbers that are not too large."""
    with np.errstate(invalid="ignore"):
        return np.asarray((np.abs(positions) < FARTHEST_M).all(axis=-1))


def thinned(count: int, most: float) -> slice:
    """Return the slice that takes every second, third ... of `count` points: at most `most`."""
    return slice(None, None, max(-(-count // max(int(most), 1)), 1))


def positions_of(points: Iterable[Any], what: str) -> NDArray[np.float32]:
    """Return `geometry_msgs/Point` messages as an array of shape (n, 3).

    Raises:
        DisplayError: A number is NaN, infinite or too large.
    """
    rows = np.array([(point.x, point.y, point.z) for point in points], np.float64).reshape(-1, 3)
    if not usable(rows).all():
        raise DisplayError(f"a number of {what} is NaN, infinite or larger than {FARTHEST_M:g}")
    return rows.astype(np.float32)


def check_number(value: float, what: str, *, low: float = -FARTHEST_M) -> float:
    """Return a number of a message.

    Raises:
        DisplayError: It is NaN, smaller than `low`, or too large.
    """
    if not low <= value < FARTHEST_M:
        raise DisplayError(f"{what} is {value:g}, but must be a number from {low:g} to 1e6")
    return float(value)


def strip(positions: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the pieces of a line through points, as an array of shape (n - 1, 2, 3)."""
    return np.stack([positions[:-1], positions[1:]], axis=1)
