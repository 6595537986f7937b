from __future__ import annotations

import math
import struct
import sys
import zlib
from array import array

import pytest

from zbot.web.png import LONGEST_SIDE, ImageError, encode_png, media_type

from sensor_msgs.msg import Image

RED, GREEN, BLUE = (255, 0, 0), (0, 255, 0), (0, 0, 255)


def decoded(data: bytes) -> tuple[int, int, list[list[tuple[int, ...]]]]:
    """Return width, height and rows of pixels of a PNG that zbot wrote."""
    assert data.startswith(b"\x89PNG\r\n\x1a\n")
    chunks, place = dict[bytes, bytes](), 8
    while place < len(data):
        (length,) = struct.unpack_from(">I", data, place)
        kind, body = data[place + 4 : place + 8], data[place + 8 : place + 8 + length]
        (checksum,) = struct.unpack_from(">I", data, place + 8 + length)
        assert checksum == zlib.crc32(kind + body)
        chunks[kind] = body
        place += 12 + length
    width, height, bits, colour, *_ = struct.unpack(">IIBBBBB", chunks[b"IHDR"])
    assert bits == 8
    count = 3 if colour == 2 else 1
    pixels, rows = zlib.decompress(chunks[b"IDAT"]), []
    for row in range(height):
        line = pixels[row * (width * count + 1) :][: width * count + 1]
        assert line[0] == 0
        rows.append([tuple(line[1 + count * x :][:count]) for x in range(width)])
    return width, height, rows


def image(encoding: str, width: int, height: int, data: bytes, step: int = 0) -> Image:
    return Image(encoding=encoding, width=width, height=height, step=step, data=data)


@pytest.mark.parametrize(
    ("encoding", "data"),
    [
        ("rgb8", bytes([*RED, *GREEN])),
        ("bgr8", bytes([*BLUE, *GREEN])),
        ("8UC3", bytes([*BLUE, *GREEN])),
        ("rgba8", bytes([*RED, 7, *GREEN, 7])),
        ("bgra8", bytes([*BLUE, 7, *GREEN, 7])),
        ("rgb16", struct.pack("<6H", 65535, 0, 0, 0, 65535, 0)),
        ("bgr16", struct.pack("<6H", 0, 0, 65535, 0, 65535, 0)),
    ],
)
def test_colours_are_read_by_the_encoding(encoding: str, data: bytes) -> None:
    assert decoded(encode_png(image(encoding, 2, 1, data))) == (2, 1, [[RED, GREEN]])


@pytest.mark.parametrize(
    ("encoding", "data"),
    [
        ("mono8", bytes([0, 200])),
        ("8UC1", bytes([0, 200])),
        ("bayer_rggb8", bytes([0, 200])),
        ("uyvy", bytes([9, 0, 9, 200])),
        ("yuv422", bytes([9, 0, 9, 200])),
        ("yuv422_yuy2", bytes([0, 9, 200, 9])),
        ("nv12", bytes([0, 200, 9])),
        ("mono16", struct.pack("<2H", 0, 200 * 257)),
    ],
)
def test_grey_is_shown_as_grey(encoding: str, data: bytes) -> None:
    assert decoded(encode_png(image(encoding, 2, 1, data))) == (2, 1, [[(0,), (200,)]])


@pytest.mark.parametrize(("encoding", "typecode"), [("16UC1", "H"), ("32FC1", "f"), ("64FC1", "d")])
def test_depth_is_scaled_to_the_measured_range(encoding: str, typecode: str) -> None:
    numbers = array(typecode, [0, 1000, 1500, 2000])
    shown = decoded(encode_png(image(encoding, 4, 1, numbers.tobytes())))[2]
    assert shown == [[(0,), (0,), (127,), (255,)]]


def test_depth_without_a_number_is_black() -> None:
    numbers = array("f", [math.nan, math.inf, -math.inf, 1.0, 2.0])
    shown = decoded(encode_png(image("32FC1", 5, 1, numbers.tobytes())))[2]
    assert shown == [[(0,), (0,), (0,), (0,), (255,)]]


def test_image_with_equal_or_missing_values_is_black() -> None:
    assert decoded(encode_png(image("32FC1", 2, 1, array("f", [3, 3]).tobytes())))[2] == [
        [(0,), (0,)]
    ]
    nothing = array("f", [math.nan, math.nan]).tobytes()
    assert decoded(encode_png(image("32FC1", 2, 1, nothing)))[2] == [[(0,), (0,)]]


def test_big_endian_numbers_are_swapped() -> None:
    numbers = array("H", [0, 65535])
    if sys.byteorder == "little":
        numbers.byteswap()
    picture = image("mono16", 2, 1, numbers.tobytes())
    picture.is_bigendian = 1
    assert decoded(encode_png(picture))[2] == [[(0,), (255,)]]


def test_rows_may_be_padded() -> None:
    data = bytes([*RED, 1, 2, *GREEN, 3, 4])
    assert decoded(encode_png(image("rgb8", 1, 2, data, step=5)))[2] == [[RED], [GREEN]]
    assert decoded(encode_png(image("rgb8", 1, 2, data[:-2], step=5)))[2] == [[RED], [GREEN]]


@pytest.mark.parametrize(("width", "height"), [(1920, 1080), (641, 3), (481, 481), (40, 4000)])
def test_large_images_become_small_and_keep_their_corners(width: int, height: int) -> None:
    data = bytearray(3 * width * height)
    data[0:3] = bytes(RED)
    shown = decoded(encode_png(image("rgb8", width, height, bytes(data))))
    assert max(shown[:2]) <= LONGEST_SIDE
    assert shown[0] / shown[1] == pytest.approx(width / height, rel=0.35)
    assert shown[2][0][0] == RED
    assert sum(pixel == RED for row in shown[2] for pixel in row) == 1


@pytest.mark.parametrize(
    ("wrong", "reason"),
    [
        (image("rgb8", 2, 2, bytes(11)), "do not fit"),
        (image("rgb8", 4, 1, bytes(12), step=3), "do not fit"),
        (image("32FC1", 2, 2, bytes(15)), "do not fit"),
        (image("rgb8", 0, 2, b""), "empty"),
        (image("secret", 1, 1, b"1"), "'secret' cannot be shown"),
        (image("", 1, 1, b"1"), "cannot be shown"),
    ],
)
def test_unusable_image_raises_an_error(wrong: Image, reason: str) -> None:
    with pytest.raises(ImageError, match=reason):
        encode_png(wrong)


def test_media_type_comes_from_the_first_bytes() -> None:
    assert media_type(b"\xff\xd8\xff\xe0....") == "image/jpeg"
    assert media_type(encode_png(image("mono8", 1, 1, b"x"))) == "image/png"
    with pytest.raises(ImageError, match="format of the compressed image is unknown"):
        media_type(b"<svg onload=alert(1)>")
