"""Tests of maps in files."""

from __future__ import annotations

import math
import os
import sys
import tracemalloc
from typing import TYPE_CHECKING

import pytest

from zbot.libraries.navigation.map_file import (
    MapFileError,
    MapSettings,
    cells,
    read_map,
    read_settings,
    write_map,
)
from zbot.libraries.navigation.map_image import GreyImage, MapImageError, read_image, read_pgm

from nav_msgs.msg import OccupancyGrid

if TYPE_CHECKING:
    from pathlib import Path

YAML = """image: lab.pgm
resolution: 0.05
origin: [-1.5, 2.0, 1.5707963]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.196
"""
PIXELS = bytes([254, 205, 0, 100, 255, 128])


@pytest.fixture
def lab(tmp_path: Path) -> Path:
    (tmp_path / "lab.yaml").write_text(YAML)
    (tmp_path / "lab.pgm").write_bytes(b"P5\n# by a robot\n3 2\n255\n" + PIXELS)
    return tmp_path


def test_a_map_is_read_with_its_rows_from_below(lab: Path) -> None:
    grid = read_map(str(lab / "lab.yaml"))
    assert (grid.info.width, grid.info.height) == (3, 2)
    assert grid.info.resolution == pytest.approx(0.05)
    assert (grid.info.origin.position.x, grid.info.origin.position.y) == (-1.5, 2.0)
    assert grid.info.origin.orientation.z == pytest.approx(math.sqrt(0.5))
    # Grey 100 is 61 % black: between the thresholds, so it is unknown.
    assert list(grid.data) == [-1, 0, -1, 0, -1, 100]


@pytest.mark.parametrize(
    ("mode", "negate", "expected"),
    [
        ("trinary", False, [0, -1, 100, -1]),
        ("trinary", True, [100, 100, 0, -1]),
        ("scale", False, [0, 0, 100, 50]),
        ("raw", False, [-1, -1, 0, 100]),
    ],
)
def test_modes_give_greys_their_meaning(mode: str, negate: bool, expected: list[int]) -> None:
    greys = bytes([254, 205, 0, 100]) if mode == "raw" else bytes([254, 205, 0, 147])
    settings = MapSettings("a", 1, (0, 0, 0), 0.65, 0.196, mode, negate)
    if mode == "scale":
        settings = MapSettings("a", 1, (0, 0, 0), 0.6471, 0.2, mode, negate)
    found = cells(GreyImage(4, 1, greys), settings)
    assert [cell - 256 if cell > 127 else cell for cell in found] == expected


def test_transparent_cells_are_unknown() -> None:
    settings = MapSettings("a", 1, (0, 0, 0))
    assert cells(GreyImage(2, 1, b"\0\0", b"\xff\x80"), settings) == bytes([100, 255])


def test_pgm_has_two_forms_and_two_depths() -> None:
    assert read_pgm(b"P2\n# a\n2 1\n15\n15 # b\n 0").pixels == b"\xff\0"
    assert read_pgm(b"P5 2 1 65535\n\xff\xff\0\0").pixels == b"\xff\0"


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (b"P5", "the width of the PGM image is missing"),
        (b"P5 2", "the height of the PGM image is missing"),
        (b"P5 2 2 255 a", "the PGM image has 1 of 4 pixels"),
        (b"P5 99999 99999 255 a", "99999 x 99999 pixels, 255 greys is invalid"),
        (b"P5 2 2 0 abcd", "0 greys is invalid"),
        (b"P2 1 1 255 x", "is not a number"),
        (b"P2 1 1 255 -5", "is below 0"),
    ],
)
def test_a_damaged_pgm_is_refused(data: bytes, reason: str) -> None:
    with pytest.raises(MapImageError, match=reason):
        read_pgm(data)


def test_png_needs_pillow(lab: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pillow = pytest.importorskip("PIL.Image")
    pillow.new("RGBA", (2, 1), (255, 255, 255, 255)).save(lab / "lab.png")
    image = read_image(lab / "lab.png")
    assert (image.pixels, image.alpha) == (b"\xff\xff", b"\xff\xff")
    (lab / "bad.png").write_bytes(b"no image")
    with pytest.raises(MapImageError, match="is not an image that can be read"):
        read_image(lab / "bad.png")
    monkeypatch.setitem(sys.modules, "PIL", None)
    with pytest.raises(MapImageError, match=r'needs Pillow: .* -m pip install "zbot\[robot\]"'):
        read_image(lab / "lab.png")


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("[", "line 1"),
        ("a", "it must have lines such as"),
        (YAML.replace("lab.pgm", ""), "image must be the path of an image"),
        (YAML.replace("0.05", "0"), "resolution must be above 0"),
        (YAML.replace("0.05", "fast"), "resolution must be a number: it is 'fast'"),
        (YAML.replace("0.05", ".nan"), "resolution must be a number: it is nan"),
        (YAML.replace("[-1.5, 2.0, 1.5707963]", "[1]"), "origin must be a list of three numbers"),
        (YAML.replace("negate: 0", "mode: grey"), "mode must be trinary, scale, raw, not 'grey'"),
        (YAML.replace("negate: 0", ""), "negate must be a number: it is missing"),
    ],
)
def test_invalid_settings_are_refused(text: str, reason: str) -> None:
    with pytest.raises(MapFileError) as caught:
        read_settings(text)
    assert reason in str(caught.value)


def test_missing_files_are_told_apart(lab: Path) -> None:
    with pytest.raises(MapFileError) as caught:
        read_map(str(lab / "none.yaml"))
    assert (caught.value.is_missing, caught.value.is_image) == (True, False)
    (lab / "lab.pgm").unlink()
    with pytest.raises(MapFileError) as caught:
        read_map(str(lab / "lab.yaml"))
    assert (caught.value.is_missing, caught.value.is_image) == (False, True)


@pytest.mark.parametrize(
    ("mode", "image_format", "expected"),
    [
        ("", "", [0, -1, 100, 0, 100, -1]),
        ("trinary", "bmp", [0, -1, 100, 0, 100, -1]),
        ("scale", "png", [0, -1, 100, 10, 70, 50]),
        ("raw", "pgm", [0, -1, 100, 10, 70, 50]),
    ],
)
def test_a_saved_map_is_read_again(
    tmp_path: Path, mode: str, image_format: str, expected: list[int]
) -> None:
    if image_format in {"png", "bmp"}:
        pytest.importorskip("PIL.Image")
    grid = OccupancyGrid(data=[0, -1, 100, 10, 70, 50])
    grid.info.width, grid.info.height, grid.info.resolution = 3, 2, 0.1
    grid.info.origin.position.x, grid.info.origin.orientation.w = -3.0, 1.0
    path = (
        write_map(grid, str(tmp_path / "lab"), image_format, mode, 0.001, 0.999)
        if mode
        in {
            "scale",
            "raw",
        }
        else write_map(grid, str(tmp_path / "lab"), image_format, mode, 0.0, 0.0)
    )
    again = read_map(str(path))
    found = [abs(a - b) for a, b in zip(again.data, expected, strict=True)]
    assert max(found) <= (1 if mode == "scale" else 0), list(again.data)
    assert again.info.resolution == pytest.approx(0.1)
    assert again.info.origin.position.x == -3.0


@pytest.mark.parametrize(
    ("settings", "reason"),
    [
        (("gif", "", 0, 0), "the format must be pgm, png, bmp, not 'gif'"),
        (("", "grey", 0, 0), "the mode must be trinary, scale, raw, not 'grey'"),
        (("", "", 0.9, 0.5), "the thresholds must be 0 <= free < occupied <= 1, not 0.9 and 0.5"),
        (("", "", 0, 0), "the map has 1 cells, not 3 x 2"),
    ],
)
def test_a_map_that_cannot_be_saved_is_refused(
    tmp_path: Path, settings: tuple[str, str, float, float], reason: str
) -> None:
    grid = OccupancyGrid(data=[0])
    grid.info.width, grid.info.height = 3, 2
    with pytest.raises(MapFileError) as caught:
        write_map(grid, str(tmp_path / "lab"), *settings)
    assert reason in str(caught.value)


def test_a_text_image_with_too_many_words_does_not_fill_the_memory() -> None:
    data = b"P2 2 1 9 " + b"1 " * 1_000_000
    tracemalloc.start()
    assert read_pgm(data).pixels == b"\x1c\x1c"
    assert tracemalloc.get_traced_memory()[1] < 2 * len(data)
    tracemalloc.stop()


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such pipes")
def test_a_pipe_is_no_map(lab: Path) -> None:
    os.mkfifo(lab / "pipe")
    with pytest.raises(MapFileError, match="it is a device or a pipe"):
        read_map(str(lab / "pipe"))
    with pytest.raises(MapImageError, match="it is a device or a pipe"):
        read_image(lab / "pipe")
