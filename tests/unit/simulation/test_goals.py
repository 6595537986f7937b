"""Tests of the goals of a run, and of their grammar."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import pytest

from zbot.classroom.errors import ClassValueError
from zbot.simulation.errors import SimulationError
from zbot.simulation.marking.goals import FollowsWall, Reaches, StopsNear, TouchesNothing, Visits
from zbot.simulation.marking.grammar import parse_task
from zbot.simulation.marking.submissions import find_submissions

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.simulation.marking.goals import Goal

PLACES = {"exit": (1.0, 0.0), "kitchen": (2.0, 2.0)}


@dataclass
class FakeSight:
    """State of a robot that a test sets."""

    now_s: float = 0.0
    place: tuple[float, float] = (0.0, 0.0)
    way_m: float = 0.0
    stands: bool = True
    gap_m: float = math.inf
    touched: str = ""


def only_goal(text: str) -> Goal:
    """Return the goal of a text that has one."""
    (goal,) = parse_task(text, PLACES).goals
    return goal


def see(goal: Goal, **state: object) -> Goal:
    """Let a goal look at a state."""
    goal.look(FakeSight(**state))  # type: ignore[arg-type]
    return goal


@pytest.mark.parametrize(
    ("text", "kinds", "limit_s"),
    [
        ("reaches (3, -2.5) within 30 s", [Reaches], 30),
        ("reaches exit", [Reaches], 60),
        ("touches nothing", [TouchesNothing], 60),
        ("follows the wall for 5 m within 90 s", [FollowsWall], 90),
        ("stops within 0.3 m of an obstacle", [StopsNear], 60),
        ("visits exit, (1, 2) and kitchen within 20 s", [Visits], 20),
        ("reaches exit within 5 s and touches  nothing within 5 s", [Reaches, TouchesNothing], 5),
        ("visits exit and kitchen and touches nothing", [Visits, TouchesNothing], 60),
        ("runs /robot and reaches exit within 9 s", [Reaches], 9),
    ],
)
def test_goals_are_read(text: str, kinds: list[type[Goal]], limit_s: float) -> None:
    task = parse_task(text, PLACES)
    assert [type(goal) for goal in task.goals] == kinds
    assert task.limit_s == limit_s


def test_the_places_of_a_visit_stay_together() -> None:
    goal = only_goal("visits exit and (1, 2), kitchen and (0.5, -0.5) within 10 s")
    assert isinstance(goal, Visits)
    assert [target.name for target in goal.targets] == ["exit", "(1, 2)", "kitchen", "(0.5, -0.5)"]


def test_topics_and_goals_can_be_mixed() -> None:
    task = parse_task(
        "publishes geometry_msgs/Twist on /cmd_vel at >= 5 Hz and reaches exit", PLACES
    )
    assert len(task.goals) == len(task.expectations) == 1


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("reaches mars", "no place 'mars'"),
        ("reaches exitt", "did you mean 'exit'?"),
        ("reachs exit", "did you mean 'reaches'?"),
        ("reaches (1, 2", "not those of a goal"),
        ("reaches (1, 5000)", "at most 1000 m"),
        ("reaches exit within 0 s", "above 0"),
        ("stops within m of an obstacle", "not those of a goal"),
        ("flies", "it must begin with reaches, visits"),
        (" and ".join(["touches nothing"] * 60), "the limit is 50"),
        ("x" * 20_000, "more than 10000 characters"),
        ("", "it must begin with"),
    ],
)
def test_a_wrong_goal_is_one_sentence(text: str, reason: str) -> None:
    with pytest.raises(ClassValueError, match=r"cannot check|goals") as caught:
        parse_task(text, PLACES)
    assert reason in str(caught.value)


def test_a_place_is_reached_from_a_quarter_of_a_metre() -> None:
    goal = only_goal("reaches exit")
    assert not see(goal, place=(0.7, 0.0), now_s=2.0).is_met
    assert goal.problem == "reaches exit: the nearest it came was 0.30 m away, at 2.0 s"
    assert see(goal, place=(0.8, 0.0)).is_met
    assert goal.problem == ""


def test_places_are_visited_in_any_order() -> None:
    goal = see(only_goal("visits exit and kitchen"), place=(2.0, 2.1))
    assert goal.problem == "visits exit and kitchen: it did not come to exit"
    assert see(goal, place=(1.0, 0.0)).is_met


def test_the_first_touch_is_told() -> None:
    goal = see(only_goal("touches nothing"))
    assert goal.problem == ""
    see(goal, touched="wall", now_s=3.0)
    assert goal.problem == "touches nothing: it touched a wall at 3.0 s"


def test_a_wall_is_followed_around_corners_but_not_across_a_room() -> None:
    goal = only_goal("follows the wall for 2 m")
    see(goal, way_m=1.0, gap_m=0.4)
    see(goal, way_m=1.5, gap_m=0.9)  # a corner
    assert see(goal, way_m=2.6, gap_m=0.4).is_met
    goal = only_goal("follows the wall for 2 m")
    see(goal, way_m=1.0, gap_m=0.4)
    see(goal, way_m=2.0, gap_m=0.9)
    assert not see(goal, way_m=3.0, gap_m=0.4).is_met
    assert goal.problem == "follows the wall for 2 m: it drove 1.0 m of 2 m near a wall"


def test_a_robot_stops_only_after_it_has_driven_and_stands_for_a_second() -> None:
    goal = only_goal("stops within 0.3 m of an obstacle")
    see(goal, now_s=0.0, gap_m=0.2)
    assert not see(goal, now_s=5.0, gap_m=0.2).is_met, "it has not driven"
    assert goal.problem.endswith("it never stopped")
    see(goal, now_s=6.0, way_m=1.0, gap_m=0.6)
    assert not see(goal, now_s=7.0, way_m=1.0, gap_m=0.6).is_met
    assert goal.problem.endswith("it stopped 0.60 m away")
    see(goal, now_s=8.0, way_m=1.2, gap_m=0.3, stands=False)
    see(goal, now_s=9.0, way_m=1.2, gap_m=0.3)
    assert see(goal, now_s=10.0, way_m=1.2, gap_m=0.3).is_met


def test_submissions_are_files_and_folders(tmp_path: Path) -> None:
    (tmp_path / "ana.py").touch()
    (tmp_path / "notes.txt").touch()
    for name, files in {
        "ben": ["drive.py"],
        "cem": ["main.py", "a.py"],
        "dan": ["a.py", "b.py"],
        "fay": ["package.xml", "setup.py", "launch/robot.launch.xml", "launch/notes.txt"],
        "gus": ["package.xml", "setup.py"],
        "ida": ["launch/a.launch.py", "b.launch.yaml"],
    }.items():
        (tmp_path / name / "launch").mkdir(parents=True)
        for file in files:
            (tmp_path / name / file).touch()
    (tmp_path / "eva").mkdir()
    found = {item.name: item for item in find_submissions([tmp_path])}
    assert list(found) == ["ana.py", "ben", "cem", "dan", "eva", "fay", "gus", "ida"]
    assert found["cem"].program == tmp_path / "cem" / "main.py"
    assert found["dan"].problem == "the folder has 2 programs, and none is main.py"
    assert found["eva"].problem == "the folder has no program .py"
    assert found["fay"].program == tmp_path / "fay" / "launch" / "robot.launch.xml"
    assert found["gus"].problem == "the package has no launch file"
    assert found["ida"].problem == "the folder has 2 launch files, and none is main.launch.py"


def test_equal_names_get_bags_of_their_own(tmp_path: Path) -> None:
    (tmp_path / "my program.py").touch()
    found = find_submissions([tmp_path / "my program.py"] * 2)
    assert [item.bag for item in found] == ["my_program", "my_program-2"]


def test_a_missing_folder_is_one_sentence(tmp_path: Path) -> None:
    with pytest.raises(SimulationError, match="there is no file or folder"):
        find_submissions([tmp_path / "nothing"])
    with pytest.raises(SimulationError, match="has no programs"):
        find_submissions([tmp_path])
