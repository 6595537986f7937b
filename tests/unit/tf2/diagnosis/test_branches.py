"""Tests of the lines of a drawing of frames."""

from __future__ import annotations

import time

from tests.unit.tf2.diagnosis.robot import Robot


def lines(robot: Robot) -> list[str]:
    """Return the drawn frames. A missing link has a question mark."""
    return [
        "  " * branch.depth + branch.frame + ("?" if branch.missing_parent else "")
        for branch in robot.diagnosis.branches()
    ]


def test_each_frame_is_below_its_parent() -> None:
    robot = Robot()
    robot.fix("base_link", "laser")
    robot.fix("base_link", "camera")
    robot.drive(("odom", "base_link"))
    assert lines(robot) == ["odom", "  base_link", "    camera", "    laser"]


def test_a_tree_is_below_the_parent_that_it_lacks() -> None:
    robot = Robot()
    robot.fix("earth", "map")
    robot.drive(("odom", "base_link"), ("other/odom", "other/base_link"))
    assert lines(robot) == [
        "earth",
        "  map",
        "    odom?",
        "      base_link",
        "    other/odom?",
        "      other/base_link",
    ]


def test_a_tree_whose_parent_is_unknown_is_on_top() -> None:
    robot = Robot()
    robot.drive(("a/odom", "a/base_link"), ("b/odom", "b/base_link"))
    assert lines(robot) == ["a/odom", "  a/base_link", "b/odom?", "  b/base_link"]


def test_a_loop_is_drawn_once() -> None:
    robot = Robot()
    robot.drive(("a", "b"), ("b", "c"), ("c", "a"))
    assert lines(robot) == ["a", "  b", "    c", "      a"]


def test_a_frame_is_below_each_of_its_parents() -> None:
    robot = Robot()
    robot.fix("b", "c")
    robot.fix("x", "a", node="/one")
    robot.fix("y", "b", node="/one")
    robot.fix("a", "b", node="/two")
    assert lines(robot) == ["x", "  a", "    b", "      c", "y", "  b"]


def test_a_long_chain_is_drawn() -> None:
    robot = Robot()
    for number in range(1500):
        robot.fix(f"link_{number}", f"link_{number + 1}")
    assert len(lines(robot)) == 1501


def test_static_links_stay_when_the_time_jumps_back() -> None:
    robot = Robot()
    robot.fix("base_link", "laser")
    robot.drive(("odom", "base_link"))
    robot.diagnosis.clear()
    assert lines(robot) == ["base_link", "  laser"]


def test_thousands_of_trees_are_drawn_and_judged_quickly() -> None:
    robot = Robot()
    for number in range(3_000):
        robot.publish(f"place_{number}", f"object_{number}")
    begin = time.process_time()
    problems = [problem.text for problem in robot.diagnosis.problems(now_ns=robot.now_ns)]
    assert len(lines(robot)) == 6_000
    assert time.process_time() - begin < 5.0  # also on a busy machine; it took minutes
    assert "2,979 more trees are not connected with `place_0`" in problems
