"""Picture of the message rates against the size of a message, as SVG with logarithmic axes."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    Points = Sequence[tuple[float, float]]

_WIDTH, _HEIGHT = 640, 400
_LEFT, _RIGHT, _TOP, _BOTTOM = 80, 620, 44, 340
_COLORS = ("#c0392b", "#2471a3", "#7d6608")
_FONT = 'font-family="sans-serif" font-size="13" fill="#222"'
_PREFIXES = ("", "k", "M", "G")


class _Axis:
    """Maps numbers to pixels. The axis begins and ends at a power of ten."""

    def __init__(self, values: Sequence[float], start: float, end: float) -> None:
        self.first = math.floor(math.log10(min(values)))
        self.last = max(math.ceil(math.log10(max(values))), self.first + 1)
        self._start, self._end = start, end

    def place(self, value: float) -> float:
        share = (math.log10(value) - self.first) / (self.last - self.first)
        return round(self._start + share * (self._end - self._start), 1)

    def ticks(self) -> list[tuple[str, float]]:
        return [
            (f"{10 ** (power % 3)}{_PREFIXES[power // 3]}", self.place(10**power))
            for power in range(self.first, self.last + 1)
        ]


def _text(x: float, y: float, words: str, anchor: str = "middle", more: str = "") -> str:
    return f'<text x="{x}" y="{y}" text-anchor="{anchor}" {more}>{words}</text>'


def _grid(across: _Axis, up: _Axis) -> list[str]:
    lines = []
    for label, x in across.ticks():
        lines += [f'<path d="M{x} {_TOP}V{_BOTTOM}" stroke="#ddd"/>', _text(x, _BOTTOM + 18, label)]
    for label, y in up.ticks():
        lines += [
            f'<path d="M{_LEFT} {y}H{_RIGHT}" stroke="#ddd"/>',
            _text(_LEFT - 8, y + 4, label, "end"),
        ]
    return lines


def _curve(name: str, row: int, places: Points) -> list[str]:
    color = _COLORS[row]
    line = " ".join(f"{x},{y}" for x, y in places)
    key_y = _TOP + 22 + 20 * row
    return [
        f'<polyline points="{line}" fill="none" stroke="{color}" stroke-width="2.5"/>',
        *(f'<circle cx="{x}" cy="{y}" r="4" fill="{color}"/>' for x, y in places),
        f'<circle cx="{_RIGHT - 120}" cy="{key_y - 4}" r="5" fill="{color}"/>',
        _text(_RIGHT - 108, key_y, name, "start"),
    ]


def draw(title: str, curves: Mapping[str, Points]) -> str:
    """Return an SVG picture of curves with bytes and messages per second."""
    points = [point for curve in curves.values() for point in curve]
    across = _Axis([x for x, _ in points], _LEFT, _RIGHT)
    up = _Axis([y for _, y in points], _BOTTOM, _TOP)
    middle = (_TOP + _BOTTOM) / 2
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH} {_HEIGHT}" {_FONT}>',
        f'<rect width="{_WIDTH}" height="{_HEIGHT}" fill="#fff"/>',
        _text((_LEFT + _RIGHT) / 2, 24, title, more='font-weight="bold"'),
        *_grid(across, up),
        _text((_LEFT + _RIGHT) / 2, _HEIGHT - 16, "size of a message (bytes)"),
        _text(20, middle, "messages per second", more=f'transform="rotate(-90 20 {middle})"'),
    ]
    for row, (name, curve) in enumerate(curves.items()):
        lines += _curve(name, row, [(across.place(x), up.place(y)) for x, y in curve])
    return "\n".join([*lines, "</svg>"]) + "\n"
