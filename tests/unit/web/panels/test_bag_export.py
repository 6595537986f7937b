"""Tests of the export of a part of a bag from the live page."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING

import pytest
from PIL import Image

from zbot.bag import Writer
from zbot.bag.errors import BagValueError
from zbot.web.panels.bags.bag_export import export_video

from sensor_msgs.msg import CompressedImage

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
        export_video(tmp_path / "bag", "/image", 0, 2)
