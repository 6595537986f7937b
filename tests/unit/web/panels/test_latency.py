"""Tests of the latency of pictures."""

from __future__ import annotations

import pytest

from zbot.web.panels.pictures.latency import latency_text

from sensor_msgs.msg import Image
from std_msgs.msg import Header, String

MS = 10**6
SECOND = 10**9


def image(stamp_ns: int) -> Image:
    image = Image(header=Header(frame_id="camera"))
    image.header.stamp.sec, image.header.stamp.nanosec = divmod(stamp_ns, SECOND)
    return image


@pytest.mark.parametrize(
    ("late_ns", "text"),
    [
        (12 * MS, "latency 12 ms"),
        (1500 * MS, "latency 1.5 s"),
        (-2 * MS, "latency 0.0 ms"),
        (-3 * SECOND, "its clock is 3.0 s ahead"),
        (7200 * SECOND, "its clock is 2.0 hours behind"),
    ],
)
def test_the_latency_is_the_time_since_the_stamp(late_ns: int, text: str) -> None:
    now_ns = 1_700_000_000 * SECOND
    assert latency_text(image(now_ns - late_ns), now_ns, is_simulated=False) == text


def test_an_unknown_latency_has_a_reason() -> None:
    assert latency_text(image(0), SECOND, is_simulated=True) == "no time stamp"
    assert latency_text(image(SECOND), 2 * SECOND, is_simulated=True) == "simulated time"
    assert latency_text(String(), SECOND, is_simulated=False) == "no header"
