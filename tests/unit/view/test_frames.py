"""The fixed frame is chosen by itself, and a missing transform has a sentence."""

from __future__ import annotations

import time

import pytest

from tests.conftest import allowed
from tests.unit.view.messages import link
from zbot.view.frames import Frames, Tree


def frames(*links: tuple[str, str]) -> Frames:
    found = Frames()
    for parent, child in links:
        found.add_fixed_link(link(parent, child, x=1.0))
    found.refresh()
    return found


@pytest.mark.parametrize(
    ("links", "fixed"),
    [
        ([], ""),
        ([("odom", "base_link"), ("base_link", "laser")], "odom"),
        ([("map", "odom"), ("odom", "base_link"), ("world", "camera")], "map"),
        ([("a", "b"), ("map", "odom")], "map"),
        ([("a", "b"), ("b", "a")], "b"),  # a loop
    ],
)
def test_the_root_of_the_largest_tree_is_the_fixed_frame(
    links: list[tuple[str, str]], fixed: str
) -> None:
    assert frames(*links).fixed == fixed


def test_a_chosen_frame_stays() -> None:
    found = frames(("odom", "base_link"))
    found.choose("base_link")
    found.refresh()
    assert found.tree.poses["odom"].translation == (-1, 0, 0)
    found.choose("")
    found.refresh()
    assert found.fixed == "odom"


def test_without_transforms_the_frame_of_a_message_is_the_fixed_frame() -> None:
    found = frames()
    found.note("laser")
    found.refresh()
    pose, is_right = found.pose("laser", 5)
    assert is_right
    assert pose is not None
    found.add_fixed_link(link("odom", "laser"))
    found.refresh()
    assert found.fixed == "odom"


def test_poses_are_composed_along_the_tree() -> None:
    found = frames(("odom", "base_link"), ("base_link", "laser"), ("odom", "other"))
    pose, is_right = found.pose("laser", 0)
    assert is_right
    assert pose is not None
    assert pose.translation == (2, 0, 0)
    assert set(found.tree.poses) == {"odom", "base_link", "laser", "other"}


def test_a_message_is_placed_at_its_own_time() -> None:
    found = Frames()
    for second in (1, 2):
        found.set_transform(link("odom", "base_link", x=float(second), stamp_s=second), "test")
    found.refresh()
    pose, is_right = found.pose("base_link", 1_500_000_000)
    assert is_right
    assert pose is not None
    assert pose.translation[0] == pytest.approx(1.5)


def test_a_message_that_is_newer_than_the_transforms_is_placed_at_the_newest() -> None:
    found = Frames()
    for second in (1, 2):
        found.set_transform(link("odom", "base_link", x=float(second), stamp_s=second), "test")
    found.refresh()
    for stamp_ns, is_usual in ((2_100_000_000, True), (9_000_000_000, False)):
        pose, is_right = found.pose("base_link", stamp_ns)
        assert pose is not None
        assert pose.translation[0] == 2
        assert is_right is is_usual


def test_a_missing_transform_has_a_sentence() -> None:
    found = frames(("odom", "base_link"))
    assert found.pose("lazer", 0) == (None, False)
    sentence = found.why("lazer", 0, "/scan")
    assert sentence.startswith("no transform from lazer to odom: ")


def test_two_trees_are_named() -> None:
    found = frames(("map", "odom"), ("odom", "base_link"), ("camera_link", "camera"))
    assert found.tree.roots == ["map", "camera_link"]
    assert found.pose("camera", 0) == (None, False)
    assert "camera_link" in found.why("camera", 0, "/image")


def test_each_frame_has_the_root_of_its_tree() -> None:
    parents = {"b": "a", "c": "b", "x": "y", "l1": "l2", "l2": "l1", "tail": "l1", "end": "tail"}
    roots = {"b": "a", "c": "a", "x": "y", "l1": "l1", "l2": "l2", "tail": "l1", "end": "l1"}
    assert Tree(parents, {}).all_roots() == roots
    assert Tree(dict(reversed(parents.items())), {}).all_roots() == roots
    long = Tree({f"f{number + 1}": f"f{number}" for number in range(20_000)}, {})
    begin = time.process_time()
    assert long.roots == ["f0"]
    assert time.process_time() - begin < allowed(1)
