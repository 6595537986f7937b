from __future__ import annotations

import pytest

import zbot  # noqa: F401 - makes the message packages importable
from zbot.observer.value_text import MOST_ELEMENTS, MOST_ROWS, amount, brief, tree

from geometry_msgs.msg import Point32, Polygon, PoseStamped, Twist
from sensor_msgs.msg import Image, LaserScan
from std_msgs.msg import Bool, Empty, String, UInt8MultiArray
from turtlesim.msg import Pose


@pytest.mark.parametrize(
    ("message", "text"),
    [
        (String(data="hi"), "hi"),
        (Bool(data=True), "true"),
        (Empty(), ""),
        (Pose(x=5.5, theta=1 / 3), "x: 5.5, y: 0, theta: 0.333333, linear_velocity: 0, angular_…"),
        (Twist(), "linear: {x: 0, y: 0, z: 0}, angular: {x: 0, y: 0, z: 0}"),
        (LaserScan(ranges=[1.0] * 9), None),
        (String(data="x" * 100), "x" * 59 + "…"),
    ],
)
def test_message_on_one_line(message: object, text: str | None) -> None:
    shown = brief(message, 60)
    assert len(shown) <= 60
    if text is not None:
        assert shown == text


def test_image_on_one_line_does_not_read_its_pixels() -> None:
    message = Image(width=640, height=480, encoding="rgb8", data=bytes(640 * 480 * 3))
    assert "640" in brief(message)


def test_tree_has_a_row_for_each_field_with_its_path() -> None:
    rows = tree(PoseStamped())
    assert [(row.path, row.depth, row.text) for row in rows[:5]] == [
        ("header", 0, ""),
        ("header.stamp", 1, "0.000000000"),
        ("header.frame_id", 1, ""),
        ("pose", 0, ""),
        ("pose.position", 1, ""),
    ]
    numbers = [row.path for row in rows if row.is_number]
    assert numbers[:2] == ["pose.position.x", "pose.position.y"]
    assert "pose.orientation.w" in numbers


def test_tree_of_a_list_shows_its_beginning() -> None:
    rows = {row.path: row for row in tree(LaserScan(ranges=[0.5] * 360))}
    assert rows["ranges"].text == "[360]"
    assert rows["ranges[0]"].text == "0.5"
    assert rows["ranges[0]"].is_number
    assert f"ranges[{MOST_ELEMENTS}]" not in rows
    assert rows["ranges[…]"].text == f"and {360 - MOST_ELEMENTS} more"


def test_tree_of_messages_in_lists() -> None:
    rows = {row.path: row.text for row in tree(Polygon(points=[Point32(x=1.0), Point32(y=2.0)]))}
    assert rows["points[1].y"] == "2"


def test_tree_stays_small() -> None:
    huge = Polygon(points=[Point32()] * 10_000)
    assert len(tree(huge)) <= MOST_ROWS + 1
    data = UInt8MultiArray(data=bytes(10_000_000))
    assert len(tree(data)) < 50


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (0, "Hz", ""),
        (1, "Hz", "1.00 Hz"),
        (62.5, "Hz", "62.5 Hz"),
        (125, "B/s", "125 B/s"),
        (999.9, "B/s", "1.00 kB/s"),
        (27_648_000, "B/s", "27.6 MB/s"),
        (5e12, "B/s", "5000 GB/s"),
    ],
)
def test_amounts_have_three_digits(value: float, unit: str, text: str) -> None:
    assert amount(value, unit) == text
