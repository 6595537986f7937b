"""Grey images of maps: PGM without a library, PNG and BMP with the optional library Pillow."""

from __future__ import annotations

import re
from array import array
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.errors.installation import pip_install
from zbot.text.limited_file import read_limited

if TYPE_CHECKING:
    from pathlib import Path

_MAX_BYTES = 400_000_000
_MAX_PIXELS = 100_000_000
_MAX_GREY = 65_535
_WORD = re.compile(rb"#[^\r\n]*|([^\s#]+)")
_NUMBER = re.compile(rb"(?:\s|#[^\r\n]*[\r\n])*(\d{1,6})")


class MapImageError(ZbotError, ValueError):
    """An image of a map cannot be read or written."""


@dataclass(frozen=True)
class GreyImage:
    """Image of a map. A pixel is one byte: 0 is black, 255 is white. The top row is first."""

    width: int
    height: int
    pixels: bytes
    alpha: bytes | None = None  #: 255 where a pixel is opaque; None if all pixels are opaque


def read_image(path: Path) -> GreyImage:
    """Return the image in a file.

    Raises:
        MapImageError: The file cannot be read, is no image, or is too large.
    """
    try:
        data = read_limited(path, _MAX_BYTES)
    except OSError as error:
        raise MapImageError(f"cannot read '{path}': {error.strerror}") from None
    except ValueError:
        raise MapImageError(f"{str(path)!r} is not a path") from None
    if len(data) > _MAX_BYTES:
        raise MapImageError(f"'{path}' has more than {_MAX_BYTES} bytes")
    try:
        return read_pgm(data) if data[:2] in {b"P2", b"P5"} else _read_with_pillow(path)
    except MapImageError as error:
        raise MapImageError(f"'{path}': {error}") from None


def read_pgm(data: bytes) -> GreyImage:
    """Return the image in PGM data, in the binary form (P5) or the text form (P2).

    Raises:
        MapImageError: The data is not PGM, or the image is too large.
    """
    numbers, position = [], 2
    for what in ("width", "height", "largest grey value"):
        found = _NUMBER.match(data, position)
        if found is None:
            raise MapImageError(f"the {what} of the PGM image is missing")
        numbers.append(int(found[1]))
        position = found.end()
    width, height, largest = numbers
    count = width * height
    if not 0 < count <= _MAX_PIXELS or not 0 < largest <= _MAX_GREY:
        raise MapImageError(f"a PGM image of {width} x {height} pixels, {largest} greys is invalid")
    greys = (
        _words(data, position, count)
        if data[:2] == b"P2"
        else _bytes(data, position + 1, count, largest)
    )
    if len(greys) < count:
        raise MapImageError(f"the PGM image has {len(greys)} of {count} pixels")
    if largest == 255 and isinstance(greys, bytes):
        return GreyImage(width, height, greys[:count])
    return GreyImage(
        width, height, bytes(min(255, grey * 255 // largest) for grey in greys[:count])
    )


def _words(data: bytes, position: int, count: int) -> array[int]:
    """Return the numbers of a text. One after the other, because a list of words is large."""
    found = array("i")
    try:
        for word in _WORD.finditer(data, position):
            if word[1]:
                found.append(int(word[1][:6]))
            if len(found) == count:
                break
    except ValueError:
        raise MapImageError("a grey value of the PGM image is not a number") from None
    if min(found, default=0) < 0:
        raise MapImageError("a grey value of the PGM image is below 0")
    return found


def _bytes(data: bytes, position: int, count: int, largest: int) -> bytes | array[int]:
    if largest <= 255:
        return data[position : position + count]
    found = data[position : position + 2 * count]
    pairs = zip(found[::2], found[1::2], strict=False)
    return array("i", (256 * high + low for high, low in pairs))


def _read_with_pillow(path: Path) -> GreyImage:
    try:
        from PIL import Image  # noqa: PLC0415 - an extra
    except ModuleNotFoundError:
        raise MapImageError(
            f"an image that is not PGM needs Pillow: {pip_install('zbot[robot]')}"
        ) from None
    try:
        return _grey_of(path, Image)
    except MapImageError:
        raise
    except Exception as error:  # noqa: BLE001 - damaged images raise errors of any type
        raise MapImageError(f"it is not an image that can be read: {error}") from None


def _grey_of(path: Path, pillow: Any) -> GreyImage:
    with pillow.open(path, formats=("PNG", "BMP", "PPM")) as image:
        if image.width * image.height > _MAX_PIXELS:
            raise MapImageError(f"it has more than {_MAX_PIXELS} pixels")
        has_alpha = image.mode in {"LA", "RGBA", "PA"} or "transparency" in image.info
        full = image.convert("RGBA") if has_alpha else image
        alpha = full.getchannel("A").tobytes() if has_alpha else None
        grey = full.convert("L")
        return GreyImage(grey.width, grey.height, grey.tobytes(), alpha)


def write_image(path: Path, image: GreyImage) -> None:
    """Write an image. The suffix of the path decides the format: `pgm`, `png` or `bmp`.

    Raises:
        MapImageError: The file cannot be written, or Pillow is missing.
    """
    try:
        if path.suffix == ".pgm":
            head = f"P5\n{image.width} {image.height}\n255\n"
            path.write_bytes(head.encode() + image.pixels)
            return
        try:
            from PIL import Image  # noqa: PLC0415 - an extra
        except ModuleNotFoundError:
            raise MapImageError(
                f"writing '{path}' needs Pillow: {pip_install('zbot[robot]')}"
            ) from None
        size = (image.width, image.height)
        picture = Image.frombytes("L", size, image.pixels)
        if image.alpha is not None and path.suffix == ".png":
            picture.putalpha(Image.frombytes("L", size, image.alpha))
        picture.save(path)
    except OSError as error:
        reason = error.strerror or str(error)
        raise MapImageError(f"cannot write '{path}': {reason}") from None
