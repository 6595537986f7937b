"""A view shows a bag without a domain: its topics, its transforms and its time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot  # noqa: F401 - makes the messages importable
from tests.unit.view.messages import link, scan
from zbot.bag import Reader, Writer
from zbot.bag.metadata import TopicMetadata
from zbot.observer.errors import ViewerError
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.view import bag_source
from zbot.view.bag_source import BagSource, NoOutlet
from zbot.view.frames import Frames

from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

SECOND = 10**9
START_NS = 1_700_000_000 * SECOND


class Time:
    """Clock of the machine, which a test moves."""

    def __init__(self) -> None:
        self.now_s = 100.0

    def monotonic(self) -> float:
        return self.now_s


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Time:
    made = Time()
    monkeypatch.setattr(bag_source, "time", made)
    return made


@pytest.fixture
def source(tmp_path: Path, clock: Time) -> Iterator[BagSource]:
    """Return a bag of 10 s: a latched description, static frames, a moving frame, a scan."""
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    with Writer(tmp_path / "bag") as bag:
        bag.create_topic(
            TopicMetadata("/robot_description", "std_msgs/msg/String", "cdr", (latched,))
        )
        bag.write("/robot_description", String(data="<robot/>"), START_NS)
        bag.write("/tf_static", TFMessage(transforms=[link("base", "laser", 1.0)]), START_NS)
        for second in range(11):
            time_ns = START_NS + second * SECOND
            moved = link("odom", "base", float(second), stamp_s=time_ns // SECOND)
            bag.write("/tf", TFMessage(transforms=[moved]), time_ns)
            bag.write("/scan", scan([float(second) + 1]), time_ns)
    assert clock.now_s
    with BagSource(Reader(tmp_path / "bag"), Frames()) as made:
        yield made


def newest(source: BagSource, topic: str) -> Any:
    with source.watch(topic) as watch:
        record = watch.newest
        return None if record is None else watch.read(record)


def range_in(source: BagSource) -> float:
    """Return the only range of the newest scan. It grows by 1 m each second."""
    return float(newest(source, "/scan").ranges[0])


def place_of(source: BagSource, frame: str) -> float:
    source._frames.choose("odom")
    source._frames.refresh()
    pose, is_right = source._frames.pose(frame, 0)
    assert pose is not None
    assert is_right
    return pose.translation[0]


def test_the_topics_are_those_of_the_bag(source: BagSource) -> None:
    assert ("/scan", ["sensor_msgs/msg/LaserScan"]) in source.snapshot().topics()
    assert source.length_s == 10
    assert source.now_ns() == START_NS


def test_a_bag_is_played_at_its_speed(source: BagSource, clock: Time) -> None:
    assert range_in(source) == 1
    clock.now_s += 2.5
    source.advance()
    assert range_in(source) == 3
    assert place_of(source, "laser") == 3.0
    source.set_speed(2)
    clock.now_s += 1
    source.advance()
    assert source.position_s == 4.5
    assert range_in(source) == 5


def test_a_pause_stops_the_time(source: BagSource, clock: Time) -> None:
    source.play(False)
    clock.now_s += 5
    source.advance()
    source.play(True)
    clock.now_s += 1
    source.advance()
    assert source.position_s == 1


def test_after_a_jump_the_state_before_it_is_shown(source: BagSource) -> None:
    source.has_jumped_back()
    source.seek(8.5)
    assert source.has_jumped_back()
    assert not source.has_jumped_back()
    assert range_in(source) == 9
    assert newest(source, "/robot_description").data == "<robot/>"
    assert place_of(source, "laser") == 9.0
    source.seek(2.0)
    assert range_in(source) == 3
    assert place_of(source, "base") == 2.0


def test_at_the_end_it_stops_and_begins_again(source: BagSource, clock: Time) -> None:
    clock.now_s += 99
    source.advance()
    assert (source.position_s, source.is_playing) == (10, False)
    assert range_in(source) == 11
    source.play(True)
    assert (source.position_s, source.is_playing) == (0, True)
    assert range_in(source) == 1


def test_a_topic_that_the_bag_does_not_have_is_silent(source: BagSource) -> None:
    assert newest(source, "/nothing") is None


def test_tools_do_not_publish() -> None:
    with pytest.raises(ViewerError, match="a bag is shown"):
        NoOutlet().open("/goal_pose", "geometry_msgs/msg/PoseStamped")
    assert NoOutlet().navigate(None, "/goal_pose") == []
