"""Export of a part of a bag from the live page: a table as CSV, images as a video."""

from __future__ import annotations

import io
import os
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO

from zbot.bag.columns import csv_lines
from zbot.bag.errors import BagError, BagValueError
from zbot.bag.reader import Reader
from zbot.bag.video import VideoTooLongError, write_video
from zbot.observer.image_encoder import encode_jpeg
from zbot.time import S_TO_NS
from zbot.wire.serialization import deserialize_message

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    #: Writes a part of a topic into a file: the file, the bag, the topic, the start and the end.
    Export = Callable[[BinaryIO, Path, str, int, int], None]

_MOST_BYTES = 500_000_000
_JPEG_QUALITY = 90


def new_export_file() -> Path:
    """Make an empty temporary file for an export, and return its path.

    Raises:
        BagError: The file cannot be made.
    """
    try:
        number, name = tempfile.mkstemp(prefix="zbot_export_")
    except OSError as error:
        raise _write_error(error) from error
    os.close(number)
    return Path(name)


def write_export(
    target: Path, export: Export, path: Path, topic: str, part: tuple[int, int]
) -> None:
    """Write a part of a topic into a file with `export_csv` or `export_video`.

    Args:
        target: The file.
        export: The function that writes.
        path: The bag.
        topic: The topic.
        part: The first and the last time, in nanoseconds since the epoch.

    Raises:
        BagError: The file cannot be written, or one of the errors of `export`.
    """
    try:
        with target.open("w+b") as stream:
            export(stream, path, topic, *part)
    except OSError as error:
        raise _write_error(error) from error


def _write_error(error: OSError) -> BagError:
    return BagError(f"the export cannot be written: {error.strerror or error}")


def export_csv(stream: BinaryIO, path: Path, topic: str, start_ns: int, end_ns: int) -> None:
    """Write a part of a topic as CSV.

    Raises:
        BagValueError: The CSV has more than 500 MB.
        BagError: The bag cannot be read.
    """
    total = 0
    for line in csv_lines(path, topic, start_ns, end_ns):
        data = line.encode()
        total += len(data)
        if total > _MOST_BYTES:
            raise BagValueError("the table is larger than 500 MB: choose a shorter part")
        stream.write(data)


def export_video(stream: BinaryIO, path: Path, topic: str, start_ns: int, end_ns: int) -> None:
    """Write the images in a part of a topic as an AVI video.

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
        try:
            everything = _same_size(first, pictures, width, height)
            write_video(stream, everything, width, height, rate_hz)
        except VideoTooLongError as error:
            raise BagValueError(str(error)) from error


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
