"""Encoder of PNG files, for the web page."""

from __future__ import annotations

import struct
import zlib

_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_RGBA = 6
_FASTEST = 1


def png(width: int, height: int, rgba: bytes | bytearray) -> bytes:
    """Return pixels (red, green, blue and opacity, row by row from the top) as a PNG file."""
    size = width * 4
    rows = b"".join(b"\0" + rgba[row * size : (row + 1) * size] for row in range(height))
    header = struct.pack(">IIBBBBB", width, height, 8, _RGBA, 0, 0, 0)
    chunks = ((b"IHDR", header), (b"IDAT", zlib.compress(rows, _FASTEST)), (b"IEND", b""))
    return _SIGNATURE + b"".join(_chunk(kind, data) for kind, data in chunks)


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
