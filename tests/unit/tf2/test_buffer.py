"""Tests of buffers without nodes: waiting, storing and transforming."""

from __future__ import annotations

import asyncio
import math
import threading
import time
from typing import TYPE_CHECKING, Any
from unittest.mock import Mock

import pytest

import zbot
from tests.conftest import allowed
from zbot.errors import ArgumentTypeError
from zbot.tf2 import (
    Buffer,
    BufferInterface,
    ConvertRegistration,
    ExtrapolationException,
    LookupException,
    NotImplementedException,
    TransformRegistration,
    TypeException,
    buffer_core,
)
from zbot.tf2.remote_buffer import BufferClient

from geometry_msgs.msg import (
    PointStamped,
    PoseStamped,
    Transform,
    TransformStamped,
    Vector3Stamped,
)
from std_msgs.msg import Header

if TYPE_CHECKING:
    from zbot.log.record import Record

QUARTER = (0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5))  # 90 degrees about z
LATEST = zbot.Time()


def at(seconds: float) -> zbot.Time:
    return zbot.Time(seconds=seconds)


def make_transform(
    parent: str,
    child: str,
    seconds: float = 0.0,
    move: tuple[float, float, float] = (0.0, 0.0, 0.0),
    turn: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0),
) -> TransformStamped:
    message = TransformStamped(child_frame_id=child)
    message.header.frame_id = parent
    message.header.stamp = at(seconds).to_msg()
    t, q = message.transform.translation, message.transform.rotation
    t.x, t.y, t.z = move
    q.x, q.y, q.z, q.w = turn
    return message


def numbers(found: Any) -> tuple[float, ...]:
    t, q = found.transform.translation, found.transform.rotation
    return (t.x, t.y, t.z, q.x, q.y, q.z, q.w)


@pytest.fixture
def robot() -> Buffer:
    """Return map -> odom -> base -> laser and base -> camera; laser and camera are static."""
    buffer = Buffer()
    buffer.set_transform(make_transform("map", "odom", 10.0, (1.0, 0.0, 0.0)))
    buffer.set_transform(make_transform("map", "odom", 11.0, (2.0, 0.0, 0.0)))
    buffer.set_transform(make_transform("odom", "base", 10.0))
    buffer.set_transform(make_transform("odom", "base", 12.0, (2.0, 0.0, 0.0), QUARTER))
    buffer.set_transform_static(make_transform("base", "laser", 0.0, (0.5, 0.0, 0.2)))
    buffer.set_transform_static(make_transform("base", "camera", 0.0, (0.0, 0.0, 1.0)))
    return buffer


@pytest.mark.parametrize("time", [0, 0.5])
def test_a_number_is_no_time(time: float) -> None:
    buffer = Buffer()
    with pytest.raises(TypeError, match=r"time must be a Time, e.g. Time\(\) for the newest tra"):
        buffer.lookup_transform("a", "b", time)


def test_interpolation_takes_the_shorter_rotation() -> None:
    buffer = Buffer()
    buffer.set_transform(make_transform("a", "b", 1.0))
    x, y, z, w = QUARTER
    buffer.set_transform(make_transform("a", "b", 2.0, turn=(-x, -y, -z, -w)))  # the same rotation
    turned = numbers(buffer.lookup_transform("a", "b", at(1.5)))[3:]
    assert abs(turned[3]) == pytest.approx(math.cos(math.pi / 8))


def test_siblings_need_no_time_of_frames_above_them(robot: Buffer) -> None:
    assert robot.can_transform("camera", "laser", at(1000.0))


def test_time_messages_are_accepted(robot: Buffer) -> None:
    found = robot.lookup_transform("odom", "base", at(11.0).to_msg())
    assert found.header.stamp.sec == 11


def test_leading_slashes_are_ignored() -> None:
    buffer = Buffer()
    buffer.set_transform_static(make_transform("/a", "/b"))
    assert buffer.can_transform("a", "b", LATEST)


def test_transforms_may_come_out_of_order() -> None:
    buffer = Buffer()
    for second in (1.0, 3.0, 2.0):
        buffer.set_transform(make_transform("a", "b", second, (second, 0.0, 0.0)))
    assert numbers(buffer.lookup_transform("a", "b", at(2.5)))[0] == pytest.approx(2.5)
    assert buffer.lookup_transform("a", "b", LATEST).header.stamp.sec == 3


def test_can_transform_returns_the_reason(robot: Buffer) -> None:
    assert robot.can_transform("map", "base", LATEST, return_debug_tuple=True) == (True, "")
    answer = robot.can_transform("map", "nobody", LATEST, return_debug_tuple=True)
    assert isinstance(answer, tuple)
    assert not answer[0]
    assert "nobody" in answer[1]


def test_only_static_transforms_survive_clear(robot: Buffer) -> None:
    robot.clear()
    assert not robot.can_transform("odom", "base", LATEST)
    assert robot.can_transform("camera", "laser", LATEST)


def test_a_lookup_waits_for_another_thread() -> None:
    buffer = Buffer()
    later = threading.Timer(0.05, lambda: buffer.set_transform(make_transform("a", "b", 1.0)))
    later.start()
    found = buffer.lookup_transform("a", "b", at(1.0), zbot.Duration(seconds=60))
    assert found.child_frame_id == "b"
    later.join()


def test_a_lookup_ends_with_its_timeout() -> None:
    began = time.monotonic()
    with pytest.raises(LookupException):
        Buffer().lookup_transform("a", "b", LATEST, zbot.Duration(seconds=0.05))
    assert 0.05 <= time.monotonic() - began < allowed(10)


def test_a_coroutine_waits_for_a_transform() -> None:
    buffer = Buffer()
    waiting = buffer.wait_for_transform_async("a", "b", LATEST)
    assert not waiting.done()
    buffer.set_transform_static(make_transform("c", "b"))
    assert not waiting.done()
    buffer.set_transform_static(make_transform("c", "a"))
    assert waiting.done()
    found = asyncio.run(buffer.lookup_transform_async("a", "b", LATEST))
    assert found.child_frame_id == "b"


def test_a_waiting_lookup_is_repeated_once_per_message(monkeypatch: pytest.MonkeyPatch) -> None:
    buffer = Buffer()
    buffer.set_transform_static(make_transform("map", "odom"))
    waiting = buffer.wait_for_transform_async("map", "tool", LATEST)
    looks: list[str] = []
    look = Buffer._find

    def counted(buffer: Buffer, target: str, source: str, stamp_ns: int) -> Any:
        looks.append(source)
        return look(buffer, target, source, stamp_ns)

    monkeypatch.setattr(Buffer, "_find", counted)
    with buffer.one_message():
        buffer.set_transform(make_transform("odom", "base", 1.0))
        buffer.set_transform(make_transform("base", "tool", 1.0))
        buffer.set_transform(make_transform("tool", "tip", 1.0))
        assert not waiting.done()
    assert waiting.done()
    assert looks == ["tool"]


def test_waiting_for_an_unknown_frame_searches_no_similar_name(
    robot: Buffer, monkeypatch: pytest.MonkeyPatch
) -> None:
    guesses: list[str] = []
    monkeypatch.setattr(buffer_core, "did_you_mean", lambda name, *_, **__: guesses.append(name))
    robot.wait_for_transform_async("map", "nobody", LATEST)
    robot.set_transform(make_transform("odom", "base", 20.0))
    assert guesses == []


def test_points_vectors_and_poses_are_transformed() -> None:
    buffer = Buffer()
    buffer.set_transform_static(make_transform("map", "laser", 0.0, (1.0, 0.0, 0.0), QUARTER))
    point, vector, pose = PointStamped(), Vector3Stamped(), PoseStamped()
    for stamped in (point, vector, pose):
        stamped.header.frame_id = "laser"
    point.point.x = vector.vector.x = pose.pose.position.x = 2.0
    there = buffer.transform(point, "map")
    assert isinstance(there, PointStamped)
    assert there.header.frame_id == "map"
    assert (there.point.x, there.point.y) == pytest.approx((1.0, 2.0))
    arrow = buffer.transform(vector, "map")
    assert (arrow.vector.x, arrow.vector.y) == pytest.approx((0.0, 2.0))
    placed = buffer.transform(pose, "map")
    assert (placed.pose.position.x, placed.pose.position.y) == pytest.approx((1.0, 2.0))
    assert (placed.pose.orientation.z, placed.pose.orientation.w) == pytest.approx(QUARTER[2:])
    assert point.point.x == 2.0  # the argument is unchanged


def test_objects_of_unregistered_types_are_refused(robot: Buffer) -> None:
    with pytest.raises(TypeException, match="TransformStamped"):
        robot.transform(make_transform("base", "x"), "map")


def test_only_frames_on_the_path_must_be_known_at_the_time(robot: Buffer) -> None:
    with pytest.raises(ExtrapolationException, match=r"latest data is at time 12\.000000"):
        robot.lookup_transform("odom", "base", at(13.0))  # map -> odom ends at 11 s


def test_a_frame_that_got_another_parent_is_found_in_the_old_one() -> None:
    buffer = Buffer()
    buffer.set_transform_static(make_transform("room", "table"))
    buffer.set_transform_static(make_transform("room", "hand", 0.0, (5.0, 0.0, 0.0)))
    buffer.set_transform(make_transform("table", "cup", 1.0, (1.0, 0.0, 0.0)))
    buffer.set_transform(make_transform("table", "cup", 2.0, (2.0, 0.0, 0.0)))
    buffer.set_transform(make_transform("hand", "cup", 3.0))
    buffer.set_transform(make_transform("hand", "cup", 4.0))
    assert numbers(buffer.lookup_transform("room", "cup", at(1.5)))[0] == pytest.approx(1.5)
    assert numbers(buffer.lookup_transform("room", "cup", at(3.5)))[0] == pytest.approx(5.0)
    assert numbers(buffer.lookup_transform("room", "cup", at(2.5)))[0] == pytest.approx(2.0)


def test_the_latest_common_time_is_that_of_the_oldest_frame(robot: Buffer) -> None:
    assert robot.get_latest_common_time("map", "laser").nanoseconds == 11_000_000_000
    assert robot.get_latest_common_time("camera", "laser").nanoseconds == 0


def test_can_transform_full_returns_the_reason(robot: Buffer) -> None:
    answer = robot.can_transform_full_core("base", at(13.0), "laser", at(10.0), "odom")
    assert not answer[0]
    assert "into the future" in answer[1]


def test_old_transforms_are_ignored_with_one_warning(logged: list[Record]) -> None:
    buffer = Buffer()
    buffer.set_transform(make_transform("a", "b", 100.0))
    for _ in range(2):
        buffer.set_transform(make_transform("a", "b", 1.0))
    assert ["old transforms" in record.message for record in logged] == [True]


def test_a_timeout_is_a_duration(robot: Buffer) -> None:
    seconds: Any = 1.0
    sentence = r"timeout must be a Duration, e\.g\. Duration\(seconds=1\.0\), not float: 1\.0"
    with pytest.raises(ArgumentTypeError, match=sentence):
        robot.lookup_transform("map", "base", LATEST, seconds)
    client = BufferClient.__new__(BufferClient)
    with pytest.raises(ArgumentTypeError, match=sentence):
        client.wait_for_server(seconds)
    with pytest.raises(ArgumentTypeError, match=sentence):
        client.lookup_transform("map", "base", LATEST, seconds)
    with pytest.raises(ArgumentTypeError, match=r"time must be a Time, e\.g\. Time\(\)"):
        client.lookup_transform("map", "base", seconds)


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ({"cache_time": 10}, r"cache_time must be a Duration, not int: 10; write Duration\(sec"),
        ({"cache_time": Mock()}, r"a Duration, not a node; write Buffer\(node=self\)"),
        ({"node": "arm"}, "node must be a node, not str: 'arm'"),
    ],
)
def test_a_buffer_checks_its_arguments(arguments: dict[str, Any], sentence: str) -> None:
    with pytest.raises(TypeError, match=sentence):
        Buffer(**arguments)


def test_the_name_of_a_frame_is_a_text(robot: Buffer) -> None:
    header: Any = Header(frame_id="base")
    for ask in (robot.lookup_transform, robot.can_transform, robot.wait_for_transform_async):
        with pytest.raises(TypeError, match="source_frame must be the name of a frame"):
            ask("map", header, LATEST)
    with pytest.raises(TypeError, match=r"time must be a Time, e\.g\. Time\(\)"):
        robot.lookup_transform("map", "base", zbot.Time)


def test_only_a_stamped_transform_can_be_set(robot: Buffer) -> None:
    for wrong in (Transform(), TransformStamped, [TransformStamped()]):
        with pytest.raises(AttributeError, match="needs one TransformStamped, not"):
            robot.set_transform(wrong)


class Tag:
    """Class of a program."""

    def __init__(self, header: Any, x: float) -> None:
        self.header, self.x = header, x


def test_a_program_can_register_its_own_class(robot: Buffer) -> None:
    def move(tag: Tag, transform: TransformStamped) -> Tag:
        return Tag(transform.header, tag.x + transform.transform.translation.x)

    TransformRegistration().add(Tag, move)
    ConvertRegistration().add_convert((Tag, float), lambda tag: tag.x)
    tag = Tag(make_transform("laser", "tag").header, 2.0)
    assert robot.transform(tag, "camera").x == pytest.approx(2.5)
    assert robot.transform(tag, "camera", new_type=float) == pytest.approx(2.5)
    full = robot.transform_full(tag, "camera", at(11.0), "odom", new_type=Tag)
    assert full.header.frame_id == "camera"
    with pytest.raises(TypeException, match="Tag cannot be converted to str"):
        robot.transform(tag, "camera", new_type=str)


def test_an_interface_has_no_lookups() -> None:
    with pytest.raises(NotImplementedException, match="BufferInterface has no lookup_transform"):
        BufferInterface().lookup_transform("a", "b", LATEST)
    with pytest.raises(NotImplementedException, match="lookup_transform_full"):
        BufferInterface().lookup_transform_full("a", LATEST, "b", LATEST, "c")


def test_a_long_chain_of_frames_is_climbed_quickly() -> None:
    buffer = Buffer()
    for number in range(9000):
        buffer.set_transform_static(make_transform(f"f{number}", f"f{number + 1}"), "test")
    begin = time.process_time()
    for _ in range(5):
        assert len(buffer._ancestors("f9000")) == 9001
        assert [len(part) for part in buffer._path("f4000", "f9000")] == [5000, 0]
    assert time.process_time() - begin < allowed(1)
