"""Drawing of the turtles: lines for web pages, and pixels for the colour sensor."""

from __future__ import annotations

import itertools
import struct
import zlib
from collections import deque
from typing import NamedTuple

WIDTH = HEIGHT = 500  #: pixels
_UNTOUCHED = (255, 255, 255, 0)  # white for the colour sensor, transparent for a page
# A turtle draws so many lines in 32 s. A page that asks for new lines less often gets a picture.
_MOST_LINES = 2000
_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_RGBA = 6
_FASTEST = 1


class Pen(NamedTuple):
    """Pen of a turtle."""

    r: int = 179
    g: int = 184
    b: int = 255
    width: int = 3  #: pixels
    is_down: bool = True


class Line(NamedTuple):
    """Straight line, in pixels from the upper left corner."""

    x0: float
    y0: float
    x1: float
    y1: float
    pen: Pen


class Drawing:
    """Drawing of 500 x 500 pixels, with its most recent lines."""

    def __init__(self) -> None:
        self.lines: deque[Line] = deque(maxlen=_MOST_LINES)
        self.until = 0  #: number of drawn lines, plus the number of times the drawing was cleared
        self._pixels = bytearray()
        self.clear()

    def clear(self) -> None:
        """Remove every line."""
        self.lines.clear()
        self.until += 1
        self._pixels[:] = bytes(_UNTOUCHED) * (WIDTH * HEIGHT)

    def add(self, line: Line) -> None:
        """Draw a line with square ends and without antialiasing. Pixels outside are ignored."""
        self.lines.append(line)
        self.until += 1
        # For square ends, a square of the pen's width is drawn on each pixel of the line.
        steps = max(1, round(max(abs(line.x1 - line.x0), abs(line.y1 - line.y0))))
        for step in range(steps + 1):
            share = step / steps
            self._stamp(
                round(line.x0 + share * (line.x1 - line.x0)),
                round(line.y0 + share * (line.y1 - line.y0)),
                line.pen,
            )

    def since(self, until: int) -> list[Line] | None:
        """Return the newest lines.

        Args:
            until: An earlier value of `self.until`. All lines since then are returned.

        Returns:
            The lines, or `None` if the drawing was cleared since then or there are too many lines.
        """
        first = self.until - len(self.lines)
        if not first <= until <= self.until:
            return None
        return list(itertools.islice(self.lines, until - first, None))

    def picture(self) -> bytes:
        """Return the drawing as a PNG file, transparent where nothing was drawn."""
        return png(WIDTH, HEIGHT, self._pixels)

    def _stamp(self, x: int, y: int, pen: Pen) -> None:
        left = max(0, x - pen.width // 2)
        right = min(WIDTH, x - pen.width // 2 + pen.width)
        if right <= left:
            return
        row = bytes((pen.r, pen.g, pen.b, 255)) * (right - left)
        top = y - pen.width // 2
        for line in range(max(0, top), min(HEIGHT, top + pen.width)):
            begin = (line * WIDTH + left) * 4
            self._pixels[begin : begin + len(row)] = row

    def colour_at(self, x: float, y: float) -> tuple[int, int, int]:
        """Return red, green and blue of the pixel at a point, or white where nothing was drawn."""
        column = min(max(round(x), 0), WIDTH - 1)
        row = min(max(round(y), 0), HEIGHT - 1)
        begin = (row * WIDTH + column) * 4
        r, g, b = self._pixels[begin : begin + 3]
        return r, g, b


def png(width: int, height: int, rgba: bytes | bytearray) -> bytes:
    """Return pixels (red, green, blue and opacity, row by row from the top) as a PNG file."""
    size = width * 4
    rows = b"".join(b"\0" + rgba[row * size : (row + 1) * size] for row in range(height))
    header = struct.pack(">IIBBBBB", width, height, 8, _RGBA, 0, 0, 0)
    chunks = ((b"IHDR", header), (b"IDAT", zlib.compress(rows, _FASTEST)), (b"IEND", b""))
    return _SIGNATURE + b"".join(_chunk(kind, data) for kind, data in chunks)


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
