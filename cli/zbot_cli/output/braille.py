"""Plot of curves as text: a canvas of braille characters with eight dots each, and axes."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import groupby
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

#: Bits of a braille character's dots, by column and row. The character is U+2800 plus its bits.
_BLANK = 0x2800
_BITS = ((0x01, 0x02, 0x04, 0x40), (0x08, 0x10, 0x20, 0x80))
#: Numbers of the curves' colours in a terminal: blue, orange, green, purple, red and cyan.
_COLOURS = (33, 208, 35, 141, 197, 44)
_SMALLEST_WIDTH, _SMALLEST_HEIGHT = 10, 3
_ROWS_A_TICK = 3
_COLUMNS_A_TICK = 16

Point = tuple[float, float]


@dataclass(frozen=True)
class Curve:
    """Curve: a name, and points in the order of time."""

    name: str
    points: Sequence[Point]  #: seconds, value


class Canvas:
    """Canvas of characters with 2 x 4 dots each.

    Args:
        width: Width in characters.
        height: Height in characters.
    """

    def __init__(self, width: int, height: int) -> None:
        self.width, self.height = width, height
        self._cells = [[0] * width for _ in range(height)]
        self._owners = [[-1] * width for _ in range(height)]

    def dot(self, x: int, y: int, owner: int) -> None:
        """Set a dot. (0, 0) is the upper left. A dot outside of the canvas is ignored."""
        column, row = x // 2, y // 4
        if 0 <= column < self.width and 0 <= row < self.height:
            self._cells[row][column] |= _BITS[x % 2][y % 4]
            self._owners[row][column] = owner

    def line(self, start: tuple[int, int], end: tuple[int, int], owner: int) -> None:
        """Set the dots of a straight line."""
        (x, y), (to_x, to_y) = start, end
        steps = max(abs(to_x - x), abs(to_y - y), 1)
        for step in range(steps + 1):
            part = step / steps
            self.dot(round(x + (to_x - x) * part), round(y + (to_y - y) * part), owner)

    def rows(self, *, coloured: bool) -> Iterator[str]:
        """Yield the rows as text. A character has the colour of the last curve drawn in it."""
        for cells, owners in zip(self._cells, self._owners, strict=True):
            marks = [chr(_BLANK + bits) if bits else " " for bits in cells]
            if not coloured:
                yield "".join(marks)
                continue
            # Neighbours of one colour share one escape sequence, so SSH sends a third of the bytes.
            runs = groupby(zip(owners, marks, strict=True), key=lambda pair: pair[0])
            yield "".join(_coloured("".join(mark for _, mark in run), owner) for owner, run in runs)


def _coloured(text: str, owner: int) -> str:
    return f"\033[38;5;{_COLOURS[owner % len(_COLOURS)]}m{text}\033[0m" if owner >= 0 else text


def ticks(low: float, high: float, most: int) -> list[float]:
    """Return at most `most` + 1 round numbers between two numbers."""
    if not high > low or most < 1:
        return [low]
    rough = (high - low) / most
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(power * digit for digit in (1, 2, 2.5, 5, 10) if power * digit >= rough * 0.999)
    first = math.ceil(low / step - 1e-9)
    last = math.floor(high / step + 1e-9)
    return [number * step for number in range(first, last + 1)]


def span(values: Iterable[float]) -> tuple[float, float]:
    """Return the range of an axis: the range of the values plus a margin. It is never empty."""
    finite = [value for value in values if math.isfinite(value)]
    if not finite:
        return -1.0, 1.0
    low, high = min(finite), max(finite)
    margin = (high - low) * 0.05 or max(abs(high) * 0.1, 0.5)
    return low - margin, high + margin


def draw(
    curves: Sequence[Curve],
    *,
    width: int,
    height: int,
    from_s: float,
    to_s: float,
    coloured: bool = False,
) -> list[str]:
    """Return a plot as lines of text.

    Args:
        curves: The curves. Points before `from_s` or after `to_s` are left out.
        width: Width of the plot with its axes, in characters.
        height: Height of the plot with its axes and legend, in lines.
        from_s: Time at the left edge.
        to_s: Time at the right edge.
        coloured: Whether each curve has its own colour.
    """
    inside = [[point for point in curve.points if from_s <= point[0] <= to_s] for curve in curves]
    low, high = span(value for points in inside for _, value in points)
    rows = max(height - 2 - len(curves), _SMALLEST_HEIGHT)
    labels = _labels(low, high, rows)
    gutter = max(map(len, labels.values()), default=1)
    canvas = Canvas(max(width - gutter - 2, _SMALLEST_WIDTH), rows)
    for owner, points in enumerate(inside):
        _trace(canvas, points, (from_s, to_s), (low, high), owner)
    legend = [_legend(curve, index, width, coloured) for index, curve in enumerate(curves)]
    body = [
        f"{labels.get(row, ''):>{gutter}} {'┤' if row in labels else '│'}{text}"
        for row, text in enumerate(canvas.rows(coloured=coloured))
    ]
    return [*legend, *body, *_time_axis(canvas.width, gutter, from_s, to_s)]


def _trace(
    canvas: Canvas, points: Sequence[Point], times: Point, values: Point, owner: int
) -> None:
    columns, rows = canvas.width * 2 - 1, canvas.height * 4 - 1
    before: tuple[int, int] | None = None
    for time_s, value in points:
        if not math.isfinite(value):
            before = None
            continue
        x = round((time_s - times[0]) / (times[1] - times[0]) * columns)
        y = round((values[1] - value) / (values[1] - values[0]) * rows)
        canvas.line(before or (x, y), (x, y), owner)
        before = (x, y)


def _labels(low: float, high: float, rows: int) -> dict[int, str]:
    """Return the numbers on the vertical axis, by row."""
    marks = ticks(low, high, max(rows // _ROWS_A_TICK, 1))
    found = {round((high - mark) / (high - low) * (rows - 1)): f"{mark:.6g}" for mark in marks}
    return {row: text for row, text in found.items() if 0 <= row < rows}


def _time_axis(width: int, gutter: int, from_s: float, to_s: float) -> list[str]:
    line, numbers = list("─" * width), [" "] * width
    for mark in ticks(from_s, to_s, max(width // _COLUMNS_A_TICK, 1)):
        column = round((mark - from_s) / (to_s - from_s) * (width - 1))
        text = f"{mark:.6g} s"
        start = min(max(column - len(text) // 2, 0), width - len(text))
        if start >= 0 and not "".join(numbers[max(start - 1, 0) : start + len(text) + 1]).strip():
            line[column] = "┬"
            numbers[start : start + len(text)] = text
    margin = " " * gutter
    return [f"{margin} └{''.join(line)}", f"{margin}  {''.join(numbers).rstrip()}"]


def _legend(curve: Curve, index: int, width: int, coloured: bool) -> str:
    last = f"{curve.points[-1][1]:.6g}" if curve.points else "no message yet"
    text = f"{curve.name}  {last}"[: max(width - 3, 1)]
    return f"{_coloured('━━', index)} {text}" if coloured else f"{text}"
