"""Colours for numbers, as in rviz."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from zbot.view.shape import Color

# rviz's rainbow: from red through yellow, green, cyan and blue to magenta.
_RAINBOW = np.array(
    [(255, 0, 0), (255, 255, 0), (0, 255, 0), (0, 255, 255), (0, 0, 255), (255, 0, 255)], np.float64
)


def rainbow(values: NDArray[Any]) -> NDArray[np.uint8]:
    """Return a colour for each number. The smallest number is red, the largest is magenta."""
    numbers = np.asarray(values, np.float64)
    usable = numbers[np.isfinite(numbers)]
    low, high = (float(usable.min()), float(usable.max())) if usable.size else (0.0, 0.0)
    share = np.zeros(len(numbers)) if high <= low else (numbers - low) / (high - low)
    place = np.clip(np.nan_to_num(share), 0, 1) * (len(_RAINBOW) - 1)
    steps = np.arange(len(_RAINBOW))
    channels = [np.interp(place, steps, _RAINBOW[:, channel]) for channel in range(3)]
    return np.stack(channels, axis=1).astype(np.uint8)


def same(color: Color, *shape: int) -> NDArray[np.uint8]:
    """Return an array of one colour, e.g. of the shape (n, 3) for `same(color, n)`."""
    found: NDArray[np.uint8] = np.broadcast_to(np.array(color, np.uint8), (*shape, 3)).copy()
    return found


def of_message(color: Any) -> Color:
    """Return a `std_msgs/ColorRGBA` as a colour. Values outside of 0 to 1 are clipped."""
    red, green, blue = (_byte(value) for value in (color.r, color.g, color.b))
    return red, green, blue


def _byte(value: float) -> int:
    return round(255 * min(max(value, 0.0), 1.0)) if value == value else 0  # noqa: PLR0124 - not for NaN
