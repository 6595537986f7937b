from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import pytest

import zbot  # noqa: F401 - makes the message packages importable
from zbot.interfaces.field_path import FieldPath, FieldPathError
from zbot.observer import curve as curve_module
from zbot.observer.curve import Curves, curve_tree, numeric_fields, split_curve, value_at
from zbot.observer.errors import ViewerError
from zbot.observer.watch import Record

from geometry_msgs.msg import Twist
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool, String

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.observer.watch import Watch
    from zbot.threads.deadline import Deadline

TOPICS = ["/turtle1", "/turtle1/pose", "/scan"]


@pytest.mark.parametrize(
    ("word", "expected"),
    [
        ("/turtle1/pose.x", ("/turtle1/pose", "x")),
        ("turtle1/pose.x", ("/turtle1/pose", "x")),
        ("/turtle1/pose/x", ("/turtle1/pose", "x")),
        ("/turtle1/pose/position/x", ("/turtle1/pose", "position.x")),
        ("/scan.ranges[3]", ("/scan", "ranges[3]")),
        ("/turtle1/pose", ("/turtle1/pose", "")),
        ("/later/pose.position.x", ("/later/pose", "position.x")),
        ("/later/pose", ("/later/pose", "")),
        ("/scan.", ("/scan", "")),
    ],
)
def test_curve_name_is_split_into_topic_and_field(word: str, expected: tuple[str, str]) -> None:
    assert split_curve(word, TOPICS) == expected


@pytest.mark.parametrize("word", ["", ".x", "/"])
def test_curve_name_without_a_topic_is_refused(word: str) -> None:
    with pytest.raises(ViewerError, match="topic is missing"):
        split_curve(word, TOPICS)


@pytest.mark.parametrize("word", ["/scan.ranges[", "/scan.a b"])
def test_curve_name_with_a_wrong_field_is_refused(word: str) -> None:
    with pytest.raises(FieldPathError):
        split_curve(word, TOPICS)


def test_numbers_of_a_message_are_found() -> None:
    assert numeric_fields(Twist())[:2] == ["linear.x", "linear.y"]
    assert numeric_fields(String()) == []


def test_values_are_numbers_and_booleans() -> None:
    assert value_at(Bool(data=True), FieldPath("data")) == 1.0
    scan = LaserScan(ranges=[0.5, math.inf])
    assert value_at(scan, FieldPath("ranges[1]")) == math.inf
    with pytest.raises(FieldPathError, match="not a number but str"):
        value_at(String(data="x"), FieldPath("data"))
    with pytest.raises(FieldPathError):
        value_at(scan, FieldPath("ranges[2]"))


class FakeWatch:
    """Topic whose messages the test defines."""

    def __init__(self) -> None:
        self.messages: list[Any] = []
        self.type_name: str | None = None
        self.problem = ""
        self.reads = 0
        self.is_released = False

    @property
    def count(self) -> int:
        return len(self.messages)

    def read_since(self, number: int, deadline: Deadline) -> Iterator[tuple[Record, Any]]:
        for index in range(number, len(self.messages)):
            self.reads += 1
            yield Record(index + 1, index * 10**9, 0, b""), self.messages[index]
            if deadline.is_over:
                return

    def release(self) -> None:
        self.is_released = True


class FakeWatcher:
    def __init__(self) -> None:
        self.watches: dict[str, FakeWatch] = {}

    def watch(self, topic: str, *, keep: int) -> Watch:  # noqa: ARG002 - as the real ones
        return self.watches.setdefault(topic, FakeWatch())  # type: ignore[return-value]


def twist(x: float, y: float) -> Twist:
    message = Twist()
    message.linear.x, message.linear.y = x, y
    return message


def test_curves_of_a_topic_read_each_message_once() -> None:
    watcher = FakeWatcher()
    curves = Curves(watcher)
    curves.add("/cmd", "linear.x")
    curves.add("/cmd", "linear.y")
    watch = watcher.watches["/cmd"]
    watch.messages += [twist(1, 2), twist(3, 4)]
    assert curves.take() == {"/cmd.linear.x": [0, 1, 1, 3], "/cmd.linear.y": [0, 2, 1, 4]}
    assert watch.reads == 2
    assert curves.take() == {}


def test_many_messages_are_read_in_several_calls(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(curve_module, "_TAKE_S", 0.0)
    watcher = FakeWatcher()
    curves = Curves(watcher)
    curves.add("/a", "data")
    curves.add("/b", "data")
    for name in ("/a", "/b"):
        watcher.watches[name].messages += [Bool(data=False), Bool(data=True)]
    assert curves.take() == {"/a.data": [0, 0], "/b.data": [0, 0]}
    assert curves.take() == {"/a.data": [1, 1], "/b.data": [1, 1]}
    assert curves.take() == {}


def test_topic_without_a_field_becomes_curves_of_its_numbers() -> None:
    watcher = FakeWatcher()
    curves = Curves(watcher)
    curves.add("/flag", "")
    assert curves.waiting == ["/flag"]
    assert curves.curves == []
    watcher.watches["/flag"].messages.append(Bool(data=True))
    assert curves.take() == {"/flag.data": [0, 1]}
    assert curves.waiting == []


def test_curve_without_points_has_a_problem() -> None:
    watcher = FakeWatcher()
    curves = Curves(watcher)
    curves.add("/cmd", "linear.w")
    (curve,) = curves.curves
    assert "no node uses /cmd" in curves.problem(curve)
    watch = watcher.watches["/cmd"]
    watch.type_name = "geometry_msgs/msg/Twist"
    watch.messages.append(twist(1, 2))
    assert curves.take() == {}
    assert "linear.w" in curves.problem(curve)


def test_last_curve_of_a_topic_releases_it() -> None:
    watcher = FakeWatcher()
    curves = Curves(watcher)
    curves.add("/cmd", "linear.x")
    curves.add("/cmd", "linear.y")
    curves.remove("/cmd.linear.x")
    assert not watcher.watches["/cmd"].is_released
    curves.remove("/cmd.linear.y")
    assert watcher.watches["/cmd"].is_released


def test_fields_are_below_their_topic_and_their_message() -> None:
    found = curve_tree({"/imu": ["rate", "linear.x", "linear.y", "covariance[0]"], "/chatter": []})
    linear = {
        "id": "/imu/linear",
        "label": "linear",
        "children": [
            {"id": "/imu.linear.x", "label": "x"},
            {"id": "/imu.linear.y", "label": "y"},
        ],
    }
    covariance = {
        "id": "/imu/covariance",
        "label": "covariance",
        "children": [{"id": "/imu.covariance[0]", "label": "[0]"}],
    }
    rate = {"id": "/imu.rate", "label": "rate"}
    imu = {"id": "/imu", "label": "/imu", "children": [rate, linear, covariance]}
    assert found == [imu, {"id": "/chatter", "label": "/chatter"}]
