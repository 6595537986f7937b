"""Tools publish what rviz publishes, and say what has happened."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

import zbot  # noqa: F401 - makes the messages importable
from zbot.observer.errors import ViewerError
from zbot.tf2.rigid import Rigid
from zbot.view.arrangement.arrangement import PointerTopics
from zbot.view.colors import same
from zbot.view.shape import Item, Label, Points
from zbot.view.tools.pointer import MOVE_CAMERA, SELECT, TOOL_NAMES, Drawn, Pointer
from zbot.view.tools.ray import Ray
from zbot.view.tools.tool import Surroundings

from geometry_msgs.msg import Point

if TYPE_CHECKING:
    from zbot.tf2.rigid import Vector


class Outlet:
    """Outlet that keeps what is sent."""

    def __init__(self) -> None:
        self.opened: list[str] = []
        self.sent: list[tuple[str, Any]] = []
        self.goals: list[Any] = []
        self.listeners = 1
        self.refusal = ""

    def open(self, topic: str, type_name: str) -> None:
        if self.refusal:
            raise ViewerError(self.refusal)
        self.opened.append(f"{topic} {type_name}")

    def send(self, topic: str, type_name: str, message: Any) -> int:
        assert f"{topic} {type_name}" in self.opened
        self.sent.append((topic, message))
        return self.listeners

    def navigate(self, pose: Any, topic: str) -> list[str]:
        self.goals.append((pose, topic))
        return ["/navigate_to_pose"]

    def ask(self, service: str, type_name: str, request: Any, answer: Any) -> None:
        raise AssertionError((service, type_name, request, answer))  # no tool asks


class Bench:
    def __init__(self, *drawn: Drawn) -> None:
        self.outlet = Outlet()
        self.frame = "map"
        topics = PointerTopics("/initialpose", "/goal_pose", "/clicked_point")
        self.pointer = Pointer(
            lambda: Surroundings(self.frame, 1_500_000_000, topics, self.outlet),
            lambda: drawn,
            lambda: {"base": Rigid((1, 2, 0)), "map": Rigid()},
        )

    def click(self, x: float, y: float) -> str:
        self.pointer.click(Ray((x, y, 5.0), (0.0, 0.0, -1.0)))
        return self.pointer.sentence


def test_a_pose_estimate_has_the_variances_of_rviz() -> None:
    bench = Bench()
    bench.pointer.choose("2D Pose Estimate")
    assert bench.pointer.sentence == "Click where the robot is."
    assert bench.click(1, 2) == "Click a place in front of the robot."
    assert not bench.outlet.sent
    said = bench.click(1, 4)
    assert said == "x = 1.00 m, y = 2.00 m, angle = 90°. Published on /initialpose."
    ((_, message),) = bench.outlet.sent
    assert (message.header.frame_id, message.header.stamp.sec) == ("map", 1)
    assert message.header.stamp.nanosec == 500_000_000
    place, turn = message.pose.pose.position, message.pose.pose.orientation
    assert (place.x, place.y, place.z) == (1, 2, 0)
    assert (turn.z, turn.w) == pytest.approx((math.sqrt(0.5), math.sqrt(0.5)))
    expected = np.zeros(36)
    expected[[0, 7, 35]] = 0.25, 0.25, 0.06853891909122467
    assert message.pose.covariance == pytest.approx(expected)


def test_a_goal_goes_to_the_topic_and_to_a_navigation() -> None:
    bench = Bench()
    bench.outlet.listeners = 0
    bench.pointer.choose("2D Goal Pose")
    bench.click(0, 0)
    assert bench.click(-1, 0) == (
        "x = 0.00 m, y = 0.00 m, angle = 180°. Published on /goal_pose, but nobody subscribes. "
        "Sent as a goal to /navigate_to_pose."
    )
    assert bench.outlet.goals == [(bench.outlet.sent[0][1], "/goal_pose")]


def test_a_point_is_published_with_one_click() -> None:
    bench = Bench()
    bench.pointer.choose("Publish Point")
    assert bench.click(3, 4) == "x = 3.00 m, y = 4.00 m. Published on /clicked_point."
    ((_, message),) = bench.outlet.sent
    assert message.point == Point(x=3.0, y=4.0)


def test_a_distance_is_measured_and_shown() -> None:
    bench = Bench()
    bench.pointer.choose("Measure")
    bench.click(0, 0)
    assert bench.click(3, 4) == "The distance is 5.00 m."
    labels = [shape for shape in bench.pointer.items["line"].shapes if isinstance(shape, Label)]
    assert labels[0].text == "5.00 m"
    assert bench.click(0, 0) == "Click where the distance ends."


def test_another_tool_forgets_the_first_click() -> None:
    bench = Bench()
    bench.pointer.choose("Measure")
    bench.click(0, 0)
    bench.pointer.choose(MOVE_CAMERA)
    assert (bench.pointer.sentence, bench.pointer.items) == ("", {})
    bench.pointer.choose("Measure")
    assert bench.click(1, 1) == "Click where the distance ends."


def test_a_click_beside_the_floor_says_so() -> None:
    bench = Bench()
    bench.pointer.choose("Publish Point")
    bench.pointer.click(Ray((0, 0, 1), (0, 0, 1)))
    assert bench.pointer.sentence.startswith("The click does not meet the floor")


def test_without_a_frame_nothing_is_published() -> None:
    bench = Bench()
    bench.frame = ""
    bench.pointer.choose("Publish Point")
    assert "no fixed frame yet" in bench.click(0, 0)
    assert not bench.outlet.sent


def test_a_refusal_is_said() -> None:
    bench = Bench()
    bench.outlet.refusal = "this page is read-only"
    bench.pointer.choose("2D Goal Pose")
    assert bench.pointer.sentence == "this page is read-only"
    assert bench.click(0, 0) == "this page is read-only"


def points(x: float, z: float) -> Item:
    places = np.array([(x, 0, z)], np.float32)
    return Item("laser", 0, (Points(places, same((0, 0, 0), 1)),))


def test_the_nearest_object_is_described() -> None:
    near = Drawn("LaserScan", "/scan", "", points(1, 1), Rigid(), Point(x=7.0))
    far = Drawn("PointCloud2", "/cloud", "", points(1, 0), Rigid(), None)
    bench = Bench(far, near)
    bench.pointer.choose(SELECT)
    said = bench.click(1, 0).splitlines()
    assert said[:3] == ["LaserScan /scan", "frame: laser", "place: 1.00, 0.00, 1.00"]
    assert "x: 7" in said
    assert bench.click(5, 5) == "There is no object. Click an object."


def test_a_frame_is_described_by_its_name() -> None:
    item = Item("", 0, (Points(np.array([(1, 2, 0)], np.float32), same((0, 0, 0), 1)),))
    bench = Bench(Drawn("TF", "", "", item, Rigid(), None))
    bench.pointer.choose(SELECT)
    assert bench.click(1, 2).splitlines()[:2] == ["TF", "frame: base"]


def test_the_tools_have_the_names_of_rviz() -> None:
    assert (
        *("Move Camera", "Interact", "Select", "2D Pose Estimate", "2D Goal Pose", "Publish Point"),
        "Measure",
    ) == TOOL_NAMES


def test_interact_presses_the_nearest_object_at_the_place_in_its_frame() -> None:
    pressed: list[Vector] = []

    def press(place: Vector) -> str:
        pressed.append(place)
        return "m was clicked."

    points = Points(np.zeros((1, 3), np.float32), same((255, 0, 0), 1))
    own = Rigid((0.5, 0.0, 0.0))  # in its frame, which is at (1, 2)
    item = Item("base", 0, (points,), own)
    bench = Bench(Drawn("InteractiveMarkers", "/u", "m/0/0", item, Rigid((1.5, 2, 0)), None, press))
    bench.pointer.choose("Interact")
    assert bench.pointer.sentence == "Click an interactive marker."
    assert bench.click(1.5, 2) == "m was clicked."
    assert pressed == [pytest.approx((0.5, 0, 0))]
    assert "no interactive marker" in bench.click(-3, -3)
