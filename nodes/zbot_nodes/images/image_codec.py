"""Conversion between images and compressed images, with the optional library Pillow."""

from __future__ import annotations

import io
import sys
from typing import Any

from zbot import ZbotError
from zbot.errors.installation import pip_install

from sensor_msgs.msg import CompressedImage, Image

_MAX_PIXELS = 50_000_000
#: For each encoding: Pillow's mode and raw mode, the bytes of a pixel, and the last word of
#: `CompressedImage.format`.
_ENCODINGS = {
    "rgb8": ("RGB", "RGB", 3, "bgr8"),
    "bgr8": ("RGB", "BGR", 3, "bgr8"),
    "rgba8": ("RGBA", "RGBA", 4, "bgra8"),
    "bgra8": ("RGBA", "BGRA", 4, "bgra8"),
    "mono8": ("L", "L", 1, "mono8"),
    "8UC1": ("L", "L", 1, ""),
    "8UC3": ("RGB", "BGR", 3, ""),
}
FORMATS = ("jpeg", "png")


class ImageCodecError(ZbotError, ValueError):
    """An image cannot be converted."""


def compress(image: Image, image_format: str = "jpeg", quality: int = 95) -> CompressedImage:
    """Return an image as JPEG or PNG.

    Args:
        image: The image.
        image_format: `jpeg` or `png`.
        quality: From 1 to 100, for JPEG.

    Raises:
        ImageCodecError: The encoding is not supported, data is missing, or Pillow is not installed.
    """
    pillow = _pillow()
    known = _ENCODINGS.get(image.encoding)
    if known is None:
        supported = ", ".join(_ENCODINGS)
        raise ImageCodecError(f"the encoding '{image.encoding}' is none of {supported}")
    mode, raw, pixel, last = known
    size, step = (image.width, image.height), image.step or image.width * pixel
    data = bytes(image.data)
    if not all(size) or step < image.width * pixel or len(data) < step * image.height:
        raise ImageCodecError(f"the image has {len(data)} bytes, which is no image of its size")
    picture = pillow.frombytes(mode, size, data[: step * image.height], "raw", raw, step)
    if image_format == "jpeg" and mode == "RGBA":
        picture = picture.convert("RGB")
    file = io.BytesIO()
    picture.save(file, image_format, **({"quality": quality} if image_format == "jpeg" else {}))
    text = f"{image.encoding}; {image_format} compressed {last}".rstrip()
    return CompressedImage(header=image.header, format=text, data=file.getvalue())


def decompress(message: CompressedImage) -> Image:
    """Return the image in a message.

    Raises:
        ImageCodecError: The data is not JPEG or PNG, the image is too large, or Pillow is not
            installed.
    """
    pillow = _pillow()
    try:
        with pillow.open(io.BytesIO(bytes(message.data)), formats=("JPEG", "PNG")) as picture:
            return _image(message, picture)
    except ImageCodecError:
        raise
    except Exception as error:  # noqa: BLE001 - damaged images raise errors of any type
        raise ImageCodecError(f"the data is no image that can be read: {error}") from None


def _image(message: CompressedImage, picture: Any) -> Image:
    if picture.width * picture.height > _MAX_PIXELS:
        raise ImageCodecError(f"the image has more than {_MAX_PIXELS} pixels")
    wanted = message.format.partition(";")[0].strip()
    encoding = wanted if wanted in _ENCODINGS else "mono8" if picture.mode == "L" else "bgr8"
    mode, raw, pixel, _ = _ENCODINGS[encoding]
    data = picture.convert(mode).tobytes("raw", raw)
    return Image(
        header=message.header,
        height=picture.height,
        width=picture.width,
        encoding=encoding,
        is_bigendian=int(sys.byteorder == "big"),
        step=picture.width * pixel,
        data=data,
    )


def _pillow() -> Any:
    try:
        from PIL import Image as pillow  # noqa: N813, PLC0415 - an extra
    except ModuleNotFoundError:
        text = f"compressed images need Pillow: {pip_install('zbot[web]')}"
        raise ImageCodecError(text) from None
    return pillow
