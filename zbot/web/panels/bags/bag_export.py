"""Export of a part of a bag from the live page: a table as CSV, images as a video."""

from __future__ import annotations

import io
import tempfile
from typing import TYPE_CHECKING, Any

from zbot.bag.columns import csv_lines
from zbot.bag.errors import BagValueError
from zbot.bag.reader import Reader
from zbot.bag.video import VideoTooLongError, write_video
from zbot.observer.image_encoder import encode_jpeg
from zbot.time import S_TO_NS
from zbot.wire.serialization import deserialize_message

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

IMAGE_TYPES = ("sensor_msgs/msg/Image", "sensor_msgs/msg/CompressedImage")
_MOST_BYTES = 500_000_000
_MOST_MEMORY = 50_000_000
_JPEG_QUALITY = 90


def export_csv(path: Path, topic: str, start_ns: int, end_ns: int) -> bytes:
    """Return a part of a topic as CSV.

    Raises:
        BagValueError: The CSV has more than 500 MB.
        BagError: The bag cannot be read.
    """
    parts, total = [], 0
    for line in csv_lines(path, topic, start_ns, end_ns):
        data = line.encode()
        total += len(data)
        if total > _MOST_BYTES:
            raise BagValueError("the table is larger than 500 MB: choose a shorter part")
        parts.append(data)
    return b"".join(parts)


def export_video(path: Path, topic: str, start_ns: int, end_ns: int) -> bytes:
    """Return the images in a part of a topic as an AVI video.

    The frame rate of the video is the mean rate of the images.

    Raises:
        BagValueError: There are no images, an image cannot be read, the images do not all have the
            same size, or the video is too long.
        BagError: The bag cannot be read.
        ImageError: An encoding is not known.
    """
    with Reader(path) as bag:
        times = [message.log_ns for message in bag.messages([topic], start_ns, end_ns)]
        if not times:
            raise BagValueError(f"topic '{topic}' has no images in this part")
        seconds = (times[-1] - times[0]) / S_TO_NS
        rate_hz = (len(times) - 1) / seconds if seconds > 0 else 10.0
        pictures = _pictures(bag, topic, start_ns, end_ns)
        first = next(pictures)
        width, height = _size(first)
        with tempfile.SpooledTemporaryFile(_MOST_MEMORY) as stream:
            try:
                everything = _same_size(first, pictures, width, height)
                write_video(stream, everything, width, height, rate_hz)  # type: ignore[arg-type]
            except VideoTooLongError as error:
                raise BagValueError(str(error)) from error
            stream.seek(0)
            return stream.read()


def _pictures(bag: Reader, topic: str, start_ns: int, end_ns: int) -> Iterator[bytes]:
    cls = bag.message_class(bag.topics[topic])
    for recorded in bag.messages([topic], start_ns, end_ns):
        message: Any = deserialize_message(recorded.data, cls)
        is_plain = hasattr(message, "encoding")
        yield encode_jpeg(message) if is_plain else _jpeg(bytes(message.data))


def _jpeg(data: bytes) -> bytes:
    """Return a compressed image as JPEG."""
    from PIL import Image  # noqa: PLC0415 - takes 40 ms

    try:
        with Image.open(io.BytesIO(data)) as picture:
            if picture.format == "JPEG":
                return data
            file = io.BytesIO()
            picture.convert("RGB").save(file, "JPEG", quality=_JPEG_QUALITY)
            return file.getvalue()
    except Exception as error:  # damaged images raise errors of any type
        raise BagValueError(f"an image cannot be read: {error}") from error


def _size(jpeg: bytes) -> tuple[int, int]:
    from PIL import Image  # noqa: PLC0415 - as above

    with Image.open(io.BytesIO(jpeg)) as picture:
        width, height = picture.size
        return width, height


def _same_size(first: bytes, others: Iterator[bytes], width: int, height: int) -> Iterator[bytes]:
    yield first
    for other in others:
        if _size(other) != (width, height):
            raise BagValueError("the images change their size: choose a shorter part")
        yield other
