"""Tests of pictures of messages that do not fit."""

from __future__ import annotations

import math

import pytest

pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')

import zbot  # noqa: F401 - makes the message packages importable
from zbot.observer.image_encoder import ImageError
from zbot.web.page.encoded_picture import image_address
from zbot.web.page.topic_picture import points_of

from sensor_msgs.msg import CompressedImage, Image, LaserScan
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage


def test_images_have_an_address() -> None:
    image = Image(width=1, height=1, encoding="mono8", step=1, data=[7])
    address, text = image_address(image)
    assert (address[:23], text) == ("data:image/jpeg;base64,", "1 x 1, mono8")
    compressed = CompressedImage(format="png", data=b"\x89PNG\r\n\x1a\n")
    address, text = image_address(compressed)
    assert (address[:22], text) == ("data:image/png;base64,", "png")


@pytest.mark.parametrize("message", [TFMessage(), String(), LaserScan()])
def test_a_message_of_another_type_is_no_image(message: object) -> None:
    with pytest.raises(ImageError, match="is no type of images"):
        image_address(message)


@pytest.mark.parametrize("angles", [(math.inf, 0.1), (0.0, math.inf), (math.nan, 0.1)])
def test_a_scan_without_angles_has_no_points(angles: tuple[float, float]) -> None:
    start, step = angles
    scan = LaserScan(angle_min=start, angle_increment=step, range_max=9.0, ranges=[2.0, 3.0])
    assert points_of(scan) == ([], 1.0)
