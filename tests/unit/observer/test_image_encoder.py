from __future__ import annotations

import io
import math
import struct
import tracemalloc
from array import array

import PIL.Image
import pytest

from zbot.observer.image_encoder import LONGEST_SIDE, ImageError, encode_jpeg, media_type

from sensor_msgs.msg import Image

RED, GREEN, BLUE = (255, 0, 0), (0, 255, 0), (0, 0, 255)


def decoded(data: bytes) -> tuple[int, int, list[list[tuple[int, ...]]]]:
    """Return width, height and rows of pixels of a JPEG file. JPEG changes colours a little."""
    picture = PIL.Image.open(io.BytesIO(data))
    assert picture.format == "JPEG"
    width, height = picture.size
    bands = [list(band.tobytes()) for band in picture.split()]
    pixels = list(zip(*bands, strict=True))
    return width, height, [pixels[row * width :][:width] for row in range(height)]


def shades(data: bytes) -> list[list[int]]:
    """Return rows of grey pixels, rounded to tens."""
    _, _, rows = decoded(data)
    return [[round(grey, -1) for (grey,) in row] for row in rows]


def colours(data: bytes) -> list[list[tuple[int, ...]]]:
    """Return rows of coloured pixels, each colour either 0 or 255."""
    _, _, rows = decoded(data)
    return [[tuple(255 * (part > 127) for part in pixel) for pixel in row] for row in rows]


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
    assert colours(encode_jpeg(image(encoding, 2, 1, data))) == [[RED, GREEN]]


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
    assert shades(encode_jpeg(image(encoding, 2, 1, data))) == [[0, 200]]


@pytest.mark.parametrize(("encoding", "typecode"), [("16UC1", "H"), ("32FC1", "f"), ("64FC1", "d")])
def test_depth_is_scaled_to_the_measured_range(encoding: str, typecode: str) -> None:
    numbers = array(typecode, [0, 1000, 1500, 2000])
    assert shades(encode_jpeg(image(encoding, 4, 1, numbers.tobytes()))) == [[0, 0, 130, 260]]


def test_depth_without_a_number_is_black() -> None:
    numbers = array("f", [math.nan, math.inf, -math.inf, 1.0, 2.0])
    ((*missing, highest),) = shades(encode_jpeg(image("32FC1", 5, 1, numbers.tobytes())))
    assert max(missing) <= 10
    assert highest >= 250


def test_image_with_equal_or_missing_values_is_black() -> None:
    same = array("f", [3, 3]).tobytes()
    assert shades(encode_jpeg(image("32FC1", 2, 1, same))) == [[0, 0]]
    nothing = array("f", [math.nan, math.nan]).tobytes()
    assert shades(encode_jpeg(image("32FC1", 2, 1, nothing))) == [[0, 0]]


@pytest.mark.parametrize(
    ("encoding", "numbers", "expected"),
    [
        ("mono16", [0, 200 * 257], [0, 200]),
        ("16UC1", [256, 512], [0, 260]),
        ("32FC1", [1.5, 2.5], [0, 260]),
    ],
)
@pytest.mark.parametrize("order", ["<", ">"])
def test_numbers_are_read_in_the_order_of_their_bytes(
    encoding: str, numbers: list[float], expected: list[int], order: str
) -> None:
    code = "f" if encoding == "32FC1" else "H"
    picture = image(encoding, 2, 1, struct.pack(f"{order}2{code}", *numbers))
    picture.is_bigendian = int(order == ">")
    assert shades(encode_jpeg(picture)) == [expected]


def test_colours_of_16_bits_are_read_in_the_order_of_their_bytes() -> None:
    picture = image("rgb16", 2, 1, struct.pack(">6H", 65280, 255, 255, 0, 65535, 0))
    picture.is_bigendian = 1
    assert colours(encode_jpeg(picture)) == [[RED, GREEN]]


@pytest.mark.parametrize("encoding", ["16UC3", "32FC3"])
def test_colours_without_a_fixed_range_are_scaled(encoding: str) -> None:
    code = "f" if encoding == "32FC3" else "H"
    data = struct.pack(f"<6{code}", 1, 1, 9, 1, 9, 1)  # blue, green, red
    assert colours(encode_jpeg(image(encoding, 2, 1, data))) == [[RED, GREEN]]


def test_rows_may_be_padded() -> None:
    data = bytes([*RED, 1, 2, *GREEN, 3, 4])
    assert colours(encode_jpeg(image("rgb8", 1, 2, data, step=5))) == [[RED], [GREEN]]
    assert colours(encode_jpeg(image("rgb8", 1, 2, data[:-2], step=5))) == [[RED], [GREEN]]
    depth = struct.pack("<HHHH", 1, 7, 9, 7)
    assert shades(encode_jpeg(image("16UC1", 1, 2, depth, step=4))) == [[0], [260]]


@pytest.mark.parametrize(("width", "height"), [(1920, 1080), (641, 4), (641, 641), (40, 4000)])
@pytest.mark.parametrize("encoding", ["mono8", "16UC1"])
def test_large_images_become_small(encoding: str, width: int, height: int) -> None:
    size = 2 if encoding == "16UC1" else 1
    half = size * width * height // 2
    shown = decoded(
        encode_jpeg(image(encoding, width, height, b"\1" * half + b"\xc8" * (half + 1)))
    )
    assert max(shown[:2]) <= LONGEST_SIDE
    assert shown[0] / shown[1] == pytest.approx(width / height, rel=0.35)
    (first,), (last,) = shown[2][0][0], shown[2][-1][-1]
    assert first < 20
    assert last > 180


@pytest.mark.parametrize(("encoding", "pixel"), [("mono8", b"\xc8"), ("16UC1", b"\1\0")])
def test_the_step_of_one_row_does_not_need_memory(encoding: str, pixel: bytes) -> None:
    one_row = image(encoding, 2, 1, 2 * pixel, step=100_000_000)
    tracemalloc.start()
    encode_jpeg(one_row)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 50_000_000


@pytest.mark.parametrize(
    ("wrong", "reason"),
    [
        (image("rgb8", 2, 2, bytes(11)), "do not fit"),
        (image("rgb8", 4, 2, bytes(24), step=3), "do not fit"),
        (image("32FC1", 2, 2, bytes(15)), "do not fit"),
        (image("rgb8", 0, 2, b""), "empty"),
        (image("secret", 1, 1, b"1"), "'secret' cannot be shown"),
        (image("", 1, 1, b"1"), "cannot be shown"),
    ],
)
def test_unusable_image_raises_an_error(wrong: Image, reason: str) -> None:
    with pytest.raises(ImageError, match=reason):
        encode_jpeg(wrong)


def test_media_type_comes_from_the_first_bytes() -> None:
    assert media_type(b"\xff\xd8\xff\xe0....") == "image/jpeg"
    assert media_type(encode_jpeg(image("mono8", 1, 1, b"x"))) == "image/jpeg"
    assert media_type(b"\x89PNG\r\n\x1a\n....") == "image/png"
    with pytest.raises(ImageError, match="format of the compressed image is unknown"):
        media_type(b"<svg onload=alert(1)>")
