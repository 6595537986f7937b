"""Writer of videos: AVI files with a JPEG for each picture. All players show such files."""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, BinaryIO

if TYPE_CHECKING:
    from collections.abc import Iterable

_KEY_FRAME = 0x10
_HAS_INDEX = 0x10
_MAX_BYTES = 2**31 - 2**20  #: AVI has 32 bits for sizes


class VideoTooLongError(ValueError):
    """A video has more bytes than an AVI file can have."""

    def __init__(self) -> None:
        super().__init__("the video is longer than 2 GB: choose a shorter part")


def write_video(
    stream: BinaryIO, pictures: Iterable[bytes], width: int, height: int, rate_hz: float
) -> int:
    """Write a video. Return the number of pictures.

    Args:
        stream: A file that is open to read and write bytes.
        pictures: A JPEG for each picture, all of the same size.
        width: Width of the pictures in pixels.
        height: Height of the pictures in pixels.
        rate_hz: Pictures in a second, above 0.

    Raises:
        OSError: The file cannot be written.
        VideoTooLongError: The video is longer than 2 GB.
    """
    start = stream.tell()
    stream.write(_header(width, height, rate_hz, 0, 0, 0))
    movie = stream.tell()
    index = bytearray()
    largest = 0
    for picture in pictures:
        place = stream.tell() - movie + 4
        if place + len(picture) > _MAX_BYTES:
            raise VideoTooLongError
        index += struct.pack("<4sIII", b"00dc", _KEY_FRAME, place, len(picture))
        stream.write(_chunk(b"00dc", picture))
        largest = max(largest, len(picture))
    movie_bytes = stream.tell() - movie + 4
    stream.write(_chunk(b"idx1", bytes(index)))
    end = stream.tell()
    count = len(index) // 16
    stream.seek(start)
    stream.write(_header(width, height, rate_hz, count, largest, movie_bytes, end - start - 8))
    stream.seek(end)
    return count


def _header(  # noqa: PLR0917 - the numbers of an AVI header
    width: int,
    height: int,
    rate_hz: float,
    count: int,
    largest: int,
    movie_bytes: int,
    file_bytes: int = 0,
) -> bytes:
    main = struct.pack(
        "<14I",
        int(1_000_000 / rate_hz),
        int(largest * rate_hz),
        0,
        _HAS_INDEX,
        count,
        0,
        1,
        largest,
        width,
        height,
        0,
        0,
        0,
        0,
    )
    track = struct.pack(
        "<4s4sIHHIIIIIIII4H",
        b"vids",
        b"MJPG",
        0,
        0,
        0,
        0,
        1000,
        max(int(rate_hz * 1000), 1),
        0,
        count,
        largest,
        2**32 - 1,
        0,
        *(0, 0, width, height),
    )
    form = struct.pack(
        "<IiiHH4sIiiII", 40, width, height, 1, 24, b"MJPG", width * height * 3, 0, 0, 0, 0
    )
    tracks = _list(b"strl", _chunk(b"strh", track) + _chunk(b"strf", form))
    headers = _list(b"hdrl", _chunk(b"avih", main) + tracks)
    riff = struct.pack("<4sI4s", b"RIFF", file_bytes, b"AVI ")
    return riff + headers + struct.pack("<4sI4s", b"LIST", movie_bytes, b"movi")


def _chunk(name: bytes, data: bytes) -> bytes:
    return struct.pack("<4sI", name, len(data)) + data + b"\0" * (len(data) % 2)


def _list(name: bytes, data: bytes) -> bytes:
    return _chunk(b"LIST", name + data)
