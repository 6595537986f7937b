"""Tests of the export of a part of a bag from the live page."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING

import pytest
from PIL import Image

from zbot.bag import Writer
from zbot.bag.errors import BagError, BagValueError
from zbot.web.panels.bags.bag_export import (
    export_csv,
    export_video,
    new_export_file,
    write_export,
)

from sensor_msgs.msg import CompressedImage
from std_msgs.msg import String

if TYPE_CHECKING:
    from pathlib import Path


def png() -> bytes:
    file = io.BytesIO()
    Image.new("RGB", (64, 64)).save(file, "PNG")
    return file.getvalue()


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"no image",
        png()[:-40],
        pytest.param(b"P6 60000 60000 255\n", id="too many pixels"),
    ],
)
def test_a_damaged_image_is_named_as_the_reason(tmp_path: Path, data: bytes) -> None:
    with Writer(tmp_path / "bag") as writer:
        writer.write("/image", CompressedImage(data=data), 1)
    with pytest.raises(BagValueError, match="an image cannot be read"):
        export_video(io.BytesIO(), tmp_path / "bag", "/image", 0, 2)


def test_an_export_is_a_file_that_the_browser_can_load(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    with Writer(tmp_path / "bag") as writer:
        writer.write("/words", String(data="one"), 1)
    target = new_export_file()
    write_export(target, export_csv, tmp_path / "bag", "/words", (0, 2))
    assert target.parent == tmp_path
    assert target.read_text().splitlines() == ["time,data", "0.000000001,one"]


def test_an_export_that_cannot_be_written_says_why(tmp_path: Path) -> None:
    with pytest.raises(BagError, match="the export cannot be written: "):
        write_export(tmp_path / "lost" / "file", export_csv, tmp_path / "bag", "/words", (0, 2))
