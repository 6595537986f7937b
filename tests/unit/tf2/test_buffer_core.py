"""Tests of the tree of frames: paths, times and errors."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

import zbot
from zbot.tf2 import (
    BufferCore,
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    buffer_core,
)
from zbot.tf2.rigid import Rigid, normalized, slerp

from geometry_msgs.msg import TransformStamped

if TYPE_CHECKING:
    from zbot.log.record import Record

NOW = zbot.Time()
numbers = st.floats(-100, 100, allow_nan=False)
rotations = (
    st.tuples(numbers, numbers, numbers, numbers)
    .filter(lambda q: sum(part * part for part in q) > 1e-3)
    .map(normalized)
)
motions = st.builds(Rigid, st.tuples(numbers, numbers, numbers), rotations)


def make_transform(
    parent: str, child: str, x: float = 0.0, *, yaw: float = 0.0, at_s: float = 1.0
) -> Any:
    message = TransformStamped(child_frame_id=child)
    message.header.frame_id = parent
    message.header.stamp = zbot.Time(nanoseconds=int(at_s * 1e9)).to_msg()
    message.transform.translation.x = float(x)
    message.transform.rotation.z = math.sin(yaw / 2)
    message.transform.rotation.w = math.cos(yaw / 2)
    return message


def place(found: Any) -> tuple[float, float, float]:
    t = found.transform.translation
    return (t.x, t.y, t.z)


def at(seconds: float) -> zbot.Time:
    return zbot.Time(nanoseconds=int(seconds * 1e9))


@pytest.fixture
def core() -> BufferCore:
    return BufferCore()


def test_a_chain_and_its_inverse_are_computed(core: BufferCore) -> None:
    core.set_transform(make_transform("map", "odom", 1, yaw=math.pi / 2))
    core.set_transform(make_transform("odom", "base", 2))
    core.set_transform_static(make_transform("base", "laser", 0.5))
    assert place(core.lookup_transform_core("map", "laser", NOW)) == pytest.approx((1, 2.5, 0))
    assert place(core.lookup_transform_core("laser", "map", NOW)) == pytest.approx((-2.5, 1, 0))
    found = core.lookup_transform_core("map", "laser", NOW)
    assert (found.header.frame_id, found.child_frame_id) == ("map", "laser")


def test_two_branches_meet_in_their_common_ancestor(core: BufferCore) -> None:
    core.set_transform_static(make_transform("base", "left", 1))
    core.set_transform_static(make_transform("base", "right", -1))
    assert place(core.lookup_transform_core("left", "right", NOW)) == pytest.approx((-2, 0, 0))


def test_a_frame_has_the_identity_to_itself(core: BufferCore) -> None:
    core.set_transform(make_transform("map", "base", 1))
    assert place(core.lookup_transform_core("base", "base", at(99))) == (0, 0, 0)


def test_a_transform_between_two_samples_is_interpolated(core: BufferCore) -> None:
    core.set_transform(make_transform("map", "base", 0, yaw=0, at_s=1))
    core.set_transform(make_transform("map", "base", 4, yaw=1, at_s=3))
    found = core.lookup_transform_core("map", "base", at(1.5))
    assert place(found) == pytest.approx((1, 0, 0))
    assert 2 * math.atan2(found.transform.rotation.z, found.transform.rotation.w) == (
        pytest.approx(0.25)
    )


def test_the_latest_time_is_that_of_the_slowest_link(core: BufferCore) -> None:
    core.set_transform(make_transform("map", "odom", 0, at_s=1))
    core.set_transform(make_transform("map", "odom", 10, at_s=2))
    core.set_transform(make_transform("odom", "base", 1, at_s=1.5))
    core.set_transform_static(make_transform("base", "laser", 0, at_s=0.1))
    found = core.lookup_transform_core("map", "laser", NOW)
    assert place(found) == pytest.approx((6, 0, 0))
    assert zbot.Time.from_msg(found.header.stamp).nanoseconds == 1_500_000_000


def test_a_lookup_between_two_times(core: BufferCore) -> None:
    for at_s in (1, 2):
        core.set_transform(make_transform("map", "base", at_s, at_s=at_s))
    found = core.lookup_transform_full_core("base", at(2), "base", at(1), "map")
    assert place(found) == pytest.approx((-1, 0, 0))


@pytest.mark.parametrize(
    ("when", "sentence"),
    [
        (5, "into the future. Requested time 5.000000 but the latest data is at time 3.000000"),
        (0.5, "into the past. Requested time 0.500000 but the earliest data is at time 1.000000"),
    ],
)
def test_nothing_is_extrapolated(core: BufferCore, when: float, sentence: str) -> None:
    core.set_transform(make_transform("map", "base", at_s=1))
    core.set_transform(make_transform("map", "base", at_s=3))
    ending = r", when looking up transform from frame \[base\] to frame \[map\]"
    with pytest.raises(ExtrapolationException, match=sentence + ending):
        core.lookup_transform_core("map", "base", at(when))


def test_one_sample_is_one_time(core: BufferCore) -> None:
    core.set_transform(make_transform("map", "base", at_s=1))
    with pytest.raises(ExtrapolationException, match=r"only time 1\.000000 is in the buffer"):
        core.lookup_transform_core("map", "base", at(2))


def test_an_unknown_frame_is_named(core: BufferCore) -> None:
    core.set_transform(make_transform("map", "base_link"))
    with pytest.raises(LookupException, match=r'"base_lnk" passed to lookupTransform.*base_link'):
        core.lookup_transform_core("map", "base_lnk", NOW)


def test_two_trees_are_not_connected(core: BufferCore) -> None:
    core.set_transform(make_transform("map", "base"))
    core.set_transform(make_transform("world", "arm"))
    with pytest.raises(ConnectivityException, match="two or more unconnected trees"):
        core.lookup_transform_core("map", "arm", NOW)


@pytest.mark.parametrize("name", ["", "/map"])
def test_names_have_no_leading_slash(core: BufferCore, name: str) -> None:
    with pytest.raises(InvalidArgumentException):
        core.lookup_transform_core(name, "base", NOW)


def test_transforms_older_than_the_cache_are_dropped() -> None:
    core = BufferCore(zbot.Duration(seconds=2))
    for at_s in range(1, 10):
        core.set_transform(make_transform("map", "base", at_s=at_s))
    assert core.can_transform_core("map", "base", at(7)) == (True, "")
    is_known, why = core.can_transform_core("map", "base", at(6))
    assert not is_known
    assert "into the past" in why
    core.set_transform(make_transform("map", "base", at_s=3))
    assert not core.can_transform_core("map", "base", at(6))[0]


@pytest.mark.parametrize(
    ("parent", "child", "change", "reason"),
    [
        ("", "base", {}, "must not be empty"),
        ("base", "base", {}, "cannot be its own parent"),
        ("map", "base", {"x": math.nan}, "infinite or NaN"),
        ("map", "base", {"w": 5.0}, "not a quaternion of length 1"),
    ],
)
def test_invalid_transforms_are_refused_with_one_warning(
    core: BufferCore,
    logged: list[Record],
    parent: str,
    child: str,
    change: dict[str, float],
    reason: str,
) -> None:
    message = make_transform(parent, child)
    message.transform.translation.x = change.get("x", 0.0)
    message.transform.rotation.w = change.get("w", 1.0)
    core.set_transform(message)
    core.set_transform(message)
    (line,) = (record.message for record in logged)
    assert reason in line


def test_a_program_that_invents_names_does_not_fill_the_memory(
    core: BufferCore, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(buffer_core, "_MOST_FRAMES", 10)
    core.set_transform_static(make_transform("base", "lidar"))
    for number in range(100):
        core.set_transform(make_transform("map", "base", at_s=number + 1))
        core.set_transform(make_transform("map", f"object_{number}", at_s=number + 1))
        assert core.can_transform_core("map", "lidar", NOW) == (True, "")
    assert len(core._frames) <= 10
    assert core.can_transform_core("map", "object_99", NOW) == (True, "")


def test_static_frames_beyond_the_most_are_refused(
    core: BufferCore, monkeypatch: pytest.MonkeyPatch, logged: list[Record]
) -> None:
    monkeypatch.setattr(buffer_core, "_MOST_FRAMES", 10)
    core.set_transform(make_transform("map", "base"))
    for number in range(20):
        core.set_transform_static(make_transform("base", f"lidar_{number}"))
    core.set_transform(make_transform("map", "base", 3.0, at_s=2))
    assert place(core.lookup_transform_core("map", "lidar_0", NOW)) == (3, 0, 0)
    assert len(core._frames) == 10
    (line,) = (record.message for record in logged)
    assert "there are 10 frames already" in line


def test_a_program_with_many_mistakes_does_not_fill_the_log(
    core: BufferCore, logged: list[Record]
) -> None:
    for number in range(200):
        core.set_transform(make_transform(f"base_{number}", f"base_{number}"))
    assert len(logged) == 100


def test_the_tree_can_be_printed(core: BufferCore) -> None:
    assert core.all_frames_as_yaml() == "[]"
    core.set_transform(make_transform("map", "base", at_s=1))
    core.set_transform(make_transform("map", "base", at_s=2))
    assert core.all_frames_as_string() == "Frame base exists with parent map.\n"
    assert "base: \n  parent: 'map'\n" in core.all_frames_as_yaml()
    core.clear()
    assert core.all_frames_as_yaml() == "[]"


@pytest.mark.parametrize("time", [NOW, at(1)])
def test_a_loop_of_frames_is_an_error_of_the_lookup(core: BufferCore, time: zbot.Time) -> None:
    core.set_transform(make_transform("a", "b"))
    core.set_transform(make_transform("b", "a"))
    core.set_transform(make_transform("map", "c"))
    with pytest.raises(LookupException, match="The tf tree is invalid because it contains a loop"):
        core.lookup_transform_core("a", "c", time)
    assert not core._is_possible("a", "c", time)


@given(motions)
def test_a_motion_and_its_inverse_do_nothing(motion: Rigid) -> None:
    for same in (motion @ motion.inverse(), motion.inverse() @ motion):
        assert same.translation == pytest.approx((0, 0, 0), abs=1e-6)
        assert abs(same.rotation[3]) == pytest.approx(1)


@given(motions, motions, st.tuples(numbers, numbers, numbers))
def test_motions_one_after_the_other(
    first: Rigid, second: Rigid, point: tuple[float, float, float]
) -> None:
    both = (second @ first).apply(point)
    assert both == pytest.approx(second.apply(first.apply(point)), abs=1e-6)


@given(rotations, rotations, st.floats(0, 1))
def test_interpolation_between_two_rotations_is_a_rotation(a: Any, b: Any, share: float) -> None:
    between = slerp(a, b, share)
    assert sum(part * part for part in between) == pytest.approx(1)
