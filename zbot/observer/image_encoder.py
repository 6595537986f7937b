"""Encoder of `sensor_msgs/Image` as JPEG, with Pillow.

The encoder reads the common encodings of camera drivers. It makes large images smaller, to send
less data to the browser. The page sends a `CompressedImage` to the browser without changes.
"""

from __future__ import annotations

import io
import sys
from array import array
from itertools import chain
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError

if TYPE_CHECKING:
    from PIL.Image import Image as Picture

IMAGE, COMPRESSED_IMAGE = "sensor_msgs/msg/Image", "sensor_msgs/msg/CompressedImage"
IMAGE_TYPES = (IMAGE, COMPRESSED_IMAGE)
#: Longest side of a sent image, in pixels. The sides of a larger image are divided by a whole
#: number.
LONGEST_SIDE = 640
#: Longest side of a sent image whose encoding is in `_NUMBERS`. This limit is lower, because Python
#: scales the numbers of these images one by one, which takes 0.2 us a pixel.
_LONGEST_SIDE_OF_NUMBERS = 480
_QUALITY = 90

#: Encodings that Pillow reads. Each has its mode and raw mode in Pillow, and the bytes of a pixel.
_RAW_MODES: dict[str, tuple[str, str, int]] = {
    "rgb8": ("RGB", "RGB", 3),
    "bgr8": ("RGB", "BGR", 3),
    "rgba8": ("RGB", "RGBX", 4),
    "bgra8": ("RGB", "BGRX", 4),
    "mono8": ("L", "L", 1),
    "8UC1": ("L", "L", 1),
    "8SC1": ("L", "L", 1),
    "8UC2": ("LA", "LA", 2),
    "8UC3": ("RGB", "BGR", 3),  # OpenCV's order
    "8UC4": ("RGB", "BGRX", 4),
    # YUV 4:2:2: every second byte is the brightness, and the page shows only the brightness
    "yuv422": ("LA", "LA", 2),
    "uyvy": ("LA", "LA", 2),
    "yuv422_yuy2": ("LA", "LA", 2),
    "yuyv": ("LA", "LA", 2),
    # For 16 bits, Pillow uses only the upper byte. `_from_bytes` appends the letter of the byte
    # order to the raw mode.
    "mono16": ("L", "L;16", 2),
    "rgb16": ("RGB", "RGB;16", 6),
    "bgr16": ("RGB", "RGB;16", 6),
    "rgba16": ("RGB", "RGBX;16", 8),
    "bgra16": ("RGB", "RGBX;16", 8),
}
#: Raw patterns of colour sensors, shown in grey.
_RAW_MODES |= {f"bayer_{pattern}8": ("L", "L", 1) for pattern in ("rggb", "bggr", "gbrg", "grbg")}
#: Encodings with separate planes. The page shows only the first plane, which is the brightness.
_RAW_MODES |= dict.fromkeys(("nv12", "nv21", "nv24", "yuv420", "i420"), ("L", "L", 1))
#: Encodings with the brightness in the second byte.
_SECOND_BYTE = frozenset({"yuv422", "uyvy"})
_BLUE_FIRST = frozenset({"bgr16", "bgra16"})
#: Encodings without a fixed range: each image has its own smallest and largest number.
#: Each has its typecode of `array`, and the positions of red, green and blue (or grey) in a pixel.
_NUMBERS: dict[str, tuple[str, tuple[int, ...]]] = {
    "16UC1": ("H", (0,)),
    "16SC1": ("h", (0,)),
    "32SC1": ("i", (0,)),
    "32FC1": ("f", (0,)),
    "64FC1": ("d", (0,)),
    "16UC3": ("H", (2, 1, 0)),
    "32FC3": ("f", (2, 1, 0)),
}
_NUMBERS |= {f"bayer_{pattern}16": ("H", (0,)) for pattern in ("rggb", "bggr", "gbrg", "grbg")}
#: First bytes of compressed images, and their media types.
_SIGNATURES = {
    b"\xff\xd8\xff": "image/jpeg",
    b"\x89PNG\r\n\x1a\n": "image/png",
    b"RIFF": "image/webp",
    b"BM": "image/bmp",
    b"GIF8": "image/gif",
}


class ImageError(ZbotError, ValueError):
    """An image message cannot be shown."""


def encode_jpeg(image: Any) -> bytes:
    """Return a `sensor_msgs/Image` as JPEG, which is at most `LONGEST_SIDE` pixels wide and high.

    In a depth image, the smallest number becomes black and the largest becomes white. Zeros and
    numbers that are not finite are missing measurements. They become black.

    Raises:
        ImageError: The encoding is unknown, or the data is too short.
    """
    if not image.width or not image.height:
        raise ImageError("the image is empty")
    if image.encoding in _NUMBERS:
        picture = _from_numbers(image, _factor(image, _LONGEST_SIDE_OF_NUMBERS))
    elif image.encoding in _RAW_MODES:
        picture = _from_bytes(image).reduce(_factor(image, LONGEST_SIDE))
    else:
        raise ImageError(f"the encoding {image.encoding!r} cannot be shown")
    file = io.BytesIO()
    picture.save(file, "JPEG", quality=_QUALITY, subsampling=0)
    return file.getvalue()


def media_type(data: bytes) -> str:
    """Return the media type of a compressed image, e.g. `image/jpeg`.

    Raises:
        ImageError: Browsers cannot show the format.
    """
    for signature, name in _SIGNATURES.items():
        if data.startswith(signature):
            return name
    raise ImageError("the format of the compressed image is unknown: use JPEG, PNG or WebP")


def _factor(image: Any, longest: int) -> int:
    side: int = max(image.width, image.height)
    return -(-side // longest)


def _from_bytes(image: Any) -> Picture:
    from PIL import Image  # noqa: PLC0415 - takes 40 ms, and only images need it

    mode, raw, pixel = _RAW_MODES[image.encoding]
    if raw.endswith("16") and (image.is_bigendian or mode != "L"):
        raw += "B" if image.is_bigendian else "L"
    data, row = _rows(image, pixel)
    size = image.width, image.height
    picture = Image.frombuffer(mode, size, data, "raw", raw, row, 1)
    if mode == "LA":
        return picture.getchannel("A" if image.encoding in _SECOND_BYTE else "L")
    if image.encoding in _BLUE_FIRST:
        return Image.merge("RGB", picture.split()[::-1])
    return picture


def _from_numbers(image: Any, factor: int) -> Picture:
    """Return a picture of every `factor`-th row and column, with numbers scaled to 0 to 255."""
    from PIL import Image  # noqa: PLC0415 - as above

    typecode, positions = _NUMBERS[image.encoding]
    numbers = array(typecode)
    count, size = len(positions), numbers.itemsize
    data, row = _rows(image, count * size)
    numbers.frombytes(data[: len(data) // size * size])
    if bool(image.is_bigendian) != (sys.byteorder == "big"):
        numbers.byteswap()
    starts = range(0, image.height * (row // size), factor * (row // size))
    length, stride = image.width * count, factor * count
    planes: list[list[float]] = [
        list(
            chain.from_iterable(
                numbers[start + offset : start + length : stride] for start in starts
            )
        )
        for offset in positions
    ]
    low, high = _range(planes)
    scale = 255 / (high - low) if high > low else 0.0
    shown = -(-image.width // factor), len(starts)
    bands = [bytes([_shade((value - low) * scale) for value in plane]) for plane in planes]
    pictures = [Image.frombytes("L", shown, band) for band in bands]
    return pictures[0] if count == 1 else Image.merge("RGB", pictures)


def _rows(image: Any, pixel: int) -> tuple[bytes, int]:
    """Return the data, filled up to complete rows, and the length of a row in bytes.

    Args:
        image: The message.
        pixel: Bytes of a pixel.

    Raises:
        ImageError: The data is too short.
    """
    data, length = bytes(image.data), image.width * pixel
    # The step is the distance of two rows. With one row it may have any value, up to 4 GB.
    row = length if image.height == 1 else image.step or length
    if row < length or len(data) < row * (image.height - 1) + length:
        raise ImageError(
            f"{image.width} x {image.height} pixels in {image.encoding} do not fit into "
            f"{len(data)} bytes in rows of {row}"
        )
    return data.ljust(row * image.height, b"\0"), row


def _range(planes: list[list[float]]) -> tuple[float, float]:
    finite = [value for plane in planes for value in plane if value - value == 0]
    # A depth of 0 is a missing measurement. It does not belong to the range.
    measured = [value for value in finite if value] or finite or [0.0]
    return min(measured), max(measured)


def _shade(value: float) -> int:
    # For NaN, both comparisons are false.
    if value >= 255:
        return 255 if value - value == 0 else 0
    return int(value) if value > 0 else 0
