"""What turtles have drawn: lines for whoever shows them, and pixels for the colour sensor."""

from __future__ import annotations

from typing import NamedTuple

WIDTH = HEIGHT = 500  #: pixels
_UNTOUCHED = (255, 255, 255)


class Pen(NamedTuple):
    """How a turtle draws."""

    r: int = 179
    g: int = 184
    b: int = 255
    width: int = 3  #: pixels
    is_down: bool = True


class Line(NamedTuple):
    """A straight line, in pixels from the upper left corner."""

    x0: float
    y0: float
    x1: float
    y1: float
    pen: Pen


class Drawing:
    """A sheet of 500 x 500 pixels."""

    def __init__(self) -> None:
        self.lines: list[Line] = []
        self._pixels = bytearray(WIDTH * HEIGHT * 3)
        self.clear()

    def clear(self) -> None:
        """Remove every line."""
        self.lines.clear()
        self._pixels[:] = bytes(_UNTOUCHED) * (WIDTH * HEIGHT)

    def add(self, line: Line) -> None:
        """Draw a line: square ends, hard edges; what lies outside the sheet is lost."""
        self.lines.append(line)
        # A square of the pen's width on each pixel of the way: that is what square caps look like.
        steps = max(1, round(max(abs(line.x1 - line.x0), abs(line.y1 - line.y0))))
        for step in range(steps + 1):
            share = step / steps
            self._stamp(
                round(line.x0 + share * (line.x1 - line.x0)),
                round(line.y0 + share * (line.y1 - line.y0)),
                line.pen,
            )

    def _stamp(self, x: int, y: int, pen: Pen) -> None:
        left = max(0, x - pen.width // 2)
        right = min(WIDTH, x - pen.width // 2 + pen.width)
        if right <= left:
            return
        row = bytes((pen.r, pen.g, pen.b)) * (right - left)
        top = y - pen.width // 2
        for line in range(max(0, top), min(HEIGHT, top + pen.width)):
            begin = (line * WIDTH + left) * 3
            self._pixels[begin : begin + len(row)] = row

    def colour_at(self, x: float, y: float) -> tuple[int, int, int]:
        """Return red, green and blue of the pixel nearest to a point, white where nobody drew."""
        column = min(max(round(x), 0), WIDTH - 1)
        row = min(max(round(y), 0), HEIGHT - 1)
        begin = (row * WIDTH + column) * 3
        r, g, b = self._pixels[begin : begin + 3]
        return r, g, b
