"""PNG encoder for `sensor_msgs/Image`, without an imaging library.

It reads the common encodings of camera drivers. It leaves out rows and columns of large images, to
send less data to the browser. The page sends a `CompressedImage` to the browser without changes.
"""

from __future__ import annotations

import struct
import sys
import zlib
from array import array
from dataclasses import dataclass
from itertools import chain
from typing import Any, TypeVar

from zbot.errors import ZbotError

#: In pixels. Larger images lose rows and columns.
LONGEST_SIDE = 480
# Level 1 is fast and halves the size of usual camera images.
_COMPRESSION = 1

#: For each encoding: bytes of a pixel, and positions of grey, or of red, green and blue.
_PLANES: dict[str, tuple[int, tuple[int, ...]]] = {
    "rgb8": (3, (0, 1, 2)),
    "bgr8": (3, (2, 1, 0)),
    "rgba8": (4, (0, 1, 2)),
    "bgra8": (4, (2, 1, 0)),
    "mono8": (1, (0,)),
    "8UC1": (1, (0,)),
    "8SC1": (1, (0,)),
    "8UC3": (3, (2, 1, 0)),  # OpenCV's order
    "8UC4": (4, (2, 1, 0)),
    "8UC2": (2, (0,)),
    # YUV 4:2:2: every second byte is the brightness, and the page shows only the brightness
    "yuv422": (2, (1,)),
    "uyvy": (2, (1,)),
    "yuv422_yuy2": (2, (0,)),
    "yuyv": (2, (0,)),
}
#: Raw patterns of colour sensors, shown in grey.
_PLANES |= {f"bayer_{pattern}8": (1, (0,)) for pattern in ("rggb", "bggr", "gbrg", "grbg")}
#: Encodings with separate planes. The page shows only the first plane, which is the brightness.
_PLANAR = frozenset({"nv12", "nv21", "nv24", "yuv420", "i420"})
#: For encodings with larger numbers: array typecode, numbers per pixel, positions as in `_PLANES`.
_NUMBERS: dict[str, tuple[str, int, tuple[int, ...]]] = {
    "mono16": ("H", 1, (0,)),
    "16UC1": ("H", 1, (0,)),
    "16SC1": ("h", 1, (0,)),
    "32SC1": ("i", 1, (0,)),
    "32FC1": ("f", 1, (0,)),
    "64FC1": ("d", 1, (0,)),
    "rgb16": ("H", 3, (0, 1, 2)),
    "bgr16": ("H", 3, (2, 1, 0)),
    "rgba16": ("H", 4, (0, 1, 2)),
    "bgra16": ("H", 4, (2, 1, 0)),
    "16UC3": ("H", 3, (2, 1, 0)),
    "32FC3": ("f", 3, (2, 1, 0)),
}
_NUMBERS |= {f"bayer_{pattern}16": ("H", 1, (0,)) for pattern in ("rggb", "bggr", "gbrg", "grbg")}
#: Encodings with a fixed range of numbers. For other encodings, the image defines the range.
_FULL_RANGE = frozenset({"mono16", "rgb16", "bgr16", "rgba16", "bgra16"})
#: First bytes of compressed images, and their media types.
_SIGNATURES = {
    b"\xff\xd8\xff": "image/jpeg",
    b"\x89PNG\r\n\x1a\n": "image/png",
    b"RIFF": "image/webp",
    b"BM": "image/bmp",
    b"GIF8": "image/gif",
}


SliceableT = TypeVar("SliceableT", bytes, "array[Any]")


class ImageError(ZbotError, ValueError):
    """An image message cannot be shown."""


def encode_png(image: Any) -> bytes:
    """Return a `sensor_msgs/Image` as PNG, which is at most `LONGEST_SIDE` pixels wide and high.

    In a depth image, the smallest number becomes black and the largest becomes white. Zeros and
    numbers that are not finite are missing measurements. They become black.

    Raises:
        ImageError: The encoding is unknown, or the data is too short.
    """
    width, height = image.width, image.height
    if not width or not height:
        raise ImageError("the image is empty")
    step = -(-max(width, height) // LONGEST_SIDE)
    planes = _planes(image, step)
    shown_width = -(-width // step)
    rows = _interleaved(planes, shown_width, -(-height // step))
    return _file(shown_width, len(rows), len(planes), rows)


def media_type(data: bytes) -> str:
    """Return the media type of a compressed image, e.g. `image/jpeg`.

    Raises:
        ImageError: Browsers cannot show the format.
    """
    for signature, name in _SIGNATURES.items():
        if data.startswith(signature):
            return name
    raise ImageError("the format of the compressed image is unknown: use JPEG, PNG or WebP")


@dataclass(frozen=True, slots=True)
class _Layout:
    """Positions of an image's pixels in its data. `row` and `pixel` count elements of the data."""

    width: int
    height: int
    row: int  #: from one row to the next row
    pixel: int  #: from one pixel to the next pixel
    step: int  #: every `step`-th row and column is used

    def rows(self, data: SliceableT, offset: int) -> list[SliceableT]:
        """Return the number at `offset` of each used pixel, as a list of rows.

        Raises:
            ImageError: The data is too short.
        """
        length = self.width * self.pixel
        if self.row < length or len(data) < self.row * (self.height - 1) + length:
            raise ImageError(
                f"{self.width} x {self.height} pixels do not fit into {len(data)} numbers "
                f"in rows of {self.row}"
            )
        starts = (number * self.row for number in range(0, self.height, self.step))
        stride = self.pixel * self.step
        return [data[start + offset : start + length : stride] for start in starts]


def _planes(image: Any, step: int) -> list[bytes]:
    """For each colour, return one byte per pixel. Only every `step`-th row and column is used."""
    encoding, data = image.encoding, bytes(image.data)
    if encoding in _NUMBERS:
        return _from_numbers(image, data, step)
    if encoding in _PLANAR:
        size, shown = _PLANES["mono8"]
    elif encoding in _PLANES:
        size, shown = _PLANES[encoding]
    else:
        raise ImageError(f"the encoding {encoding!r} cannot be shown")
    layout = _Layout(image.width, image.height, image.step or size * image.width, size, step)
    return [b"".join(layout.rows(data, offset)) for offset in shown]


def _from_numbers(image: Any, data: bytes, step: int) -> list[bytes]:
    typecode, count, shown = _NUMBERS[image.encoding]
    numbers = array(typecode)
    size = numbers.itemsize
    numbers.frombytes(data[: len(data) // size * size])
    if bool(image.is_bigendian) != (sys.byteorder == "big"):
        numbers.byteswap()
    row = (image.step or size * count * image.width) // size
    layout = _Layout(image.width, image.height, row, count, step)
    values = [list(chain.from_iterable(layout.rows(numbers, offset))) for offset in shown]
    low, high = _range(image.encoding, values)
    scale = 255 / (high - low) if high > low else 0.0
    return [bytes([_shade((one - low) * scale) for one in plane]) for plane in values]


def _range(encoding: str, planes: list[list[float]]) -> tuple[float, float]:
    if encoding in _FULL_RANGE:
        return 0.0, 65_535.0
    finite = [one for plane in planes for one in plane if one - one == 0]
    # A depth of 0 is a missing measurement. It does not belong to the range.
    measured = [one for one in finite if one] or finite or [0.0]
    return min(measured), max(measured)


def _shade(value: float) -> int:
    # For NaN, both comparisons are false.
    if value >= 255:
        return 255 if value - value == 0 else 0
    return int(value) if value > 0 else 0


def _interleaved(planes: list[bytes], width: int, height: int) -> list[bytes]:
    if len(planes) == 1:
        pixels = planes[0]
    else:
        mixed = bytearray(len(planes) * len(planes[0]))
        for offset, plane in enumerate(planes):
            mixed[offset :: len(planes)] = plane
        pixels = bytes(mixed)
    length = width * len(planes)
    return [pixels[row * length : (row + 1) * length] for row in range(height)]


def _file(width: int, height: int, colours: int, rows: list[bytes]) -> bytes:
    """Return a PNG file with 8 bits, in grey or RGB, without a filter (RFC 2083)."""
    header = struct.pack(">IIBBBBB", width, height, 8, 0 if colours == 1 else 2, 0, 0, 0)
    pixels = zlib.compress(b"".join(b"\0" + row for row in rows), _COMPRESSION)
    chunks = (_chunk(b"IHDR", header), _chunk(b"IDAT", pixels), _chunk(b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunks)


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
