"""`.rviz` files are read, and written with what the view does not have."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from zbot.package import package_share
from zbot.text.yaml_reader import read_yaml
from zbot.view.arrangement.arrangement import Arrangement, DisplayChoice
from zbot.view.arrangement.errors import ArrangementError
from zbot.view.arrangement.rviz_displays import RVIZ_DISPLAYS
from zbot.view.arrangement.rviz_file import read_rviz, read_rviz_file
from zbot.view.arrangement.rviz_writer import rviz_text
from zbot.view.camera import ANGLE, Camera, camera_at
from zbot.view.displays import DISPLAYS

FILE = Path(__file__).with_name("example.rviz")
KINDS = {display.name: display for display in DISPLAYS}


@pytest.fixture(scope="module")
def example() -> Arrangement:
    return read_rviz_file(FILE)


def one(text: str) -> DisplayChoice:
    """Return the only display of a file."""
    (found,) = read_rviz(f"Visualization Manager: {{Displays: [{{{text}}}]}}").displays
    return found


def misfits(text: str) -> tuple[str, ...]:
    return read_rviz(f"Visualization Manager: {{Displays: [{{{text}}}]}}").misfits


def test_displays_have_their_topics_and_settings(example: Arrangement) -> None:
    grid, scan, costmap, odometry, tf, other = example.displays
    assert grid.kind == "Grid"
    assert grid.values == {
        "cell size": 0.5,
        "cells": 8,
        "color": (90, 90, 90),
        "plane": "XY",
        "frame": "",
    }
    assert (scan.kind, scan.label, scan.topic) == ("LaserScan", "Front laser", "scan")
    assert scan.values == {
        "shape": "circle",
        "size": 0.3,
        "color by": "flat",
        "color": (0, 255, 0),
        "decay time": 3,
    }
    assert costmap.topic == "/local_costmap/costmap"
    assert costmap.values == {"color": "costmap", "opacity": 0.7}
    assert odometry.values["length"] == pytest.approx(0.7)
    assert tf.values == {"length": 0.4, "names": False, "hidden": "imu_link"}
    assert (other.kind, other.label) == ("", "Elevation")


def test_a_group_that_is_off_switches_its_displays_off(example: Arrangement) -> None:
    assert [choice.is_on for choice in example.displays] == [True, True, False, False, True, True]
    assert example.displays[2].groups == ("Navigation",)


def test_the_frame_the_view_and_the_tools_are_read(example: Arrangement) -> None:
    assert example.fixed_frame == "odom"
    assert example.background == (48, 48, 48)
    assert example.camera == Camera((1, 2, 0), 6, 3.14, 1.2, "base_link")
    topics = example.topics
    assert topics.initial_pose == "/robot_1/initialpose"
    assert (topics.variance_xy, topics.goal) == (0.1, "/move_base_simple/goal")
    assert topics.point == "clicked_point"


def test_what_does_not_fit_is_named_once(example: Arrangement) -> None:
    assert example.misfits == (
        "LaserScan: Invert Rainbow",
        "display GridMap",
        "tool Paint",
        "panel Buttons",
    )
    assert "Invert Rainbow, display GridMap" in example.misfit_sentence


def test_a_value_that_cannot_be_used_is_named_and_left_out() -> None:
    text = "Class: rviz/LaserScan, Topic: a, Size (m): .nan, Color: red, Style: [1]"
    assert one(text).values == {}
    assert misfits(text) == ("LaserScan: Style", "LaserScan: Size (m) nan", "LaserScan: Color red")


def test_usual_values_are_no_misfits() -> None:
    text = "Class: rviz/LaserScan, Topic: a, Decay Time: 0, Alpha: 1, Use rainbow: true"
    assert misfits(text) == ()
    assert misfits("Class: rviz_default_plugins/Camera, Far Plane Distance: 100") == ()
    panels = "Panels: [{Class: rviz_common/Help}, {Class: rviz_common/Displays}]"
    assert read_rviz(f"Visualization Manager: {{}}\n{panels}").misfits == ()


@pytest.mark.parametrize(
    ("text", "topic"),
    [
        ("Class: rviz/Image, Image Topic: /camera/image", "/camera/image"),
        ("Class: rviz/Marker, Marker Topic: marks", "marks"),
        ("Class: rviz/RobotModel, Robot Description: robot_description", "robot_description"),
        ("Class: rviz_default_plugins/RobotModel, Description Topic: {Value: /r/d}", "/r/d"),
        ("Class: rviz_default_plugins/Path, Topic: {Value: ''}", ""),
        ("Class: rviz/InteractiveMarkers, Update Topic: /tools/update", "/tools/update"),
        (
            "Class: rviz_default_plugins/InteractiveMarkers, Interactive Markers Namespace: /tools",
            "/tools/update",
        ),
    ],
)
def test_all_forms_of_topics_are_read(text: str, topic: str) -> None:
    assert one(text).topic == topic


def test_points_that_are_drawn_in_pixels_get_a_size_in_metres() -> None:
    text = "Class: rviz/PointCloud2, Topic: a, Style: Points, Size (Pixels): 5, Size (m): 0.5"
    assert one(text).values["size"] == 0.05


def test_the_axis_of_a_colouring_is_part_of_it() -> None:
    text = "Class: rviz/PointCloud2, Topic: a, Color Transformer: AxisColor, Axis: X"
    assert one(text).values["color by"] == "x"


def test_a_robot_may_come_from_a_file() -> None:
    text = "Class: rviz_default_plugins/RobotModel, Description Source: File, Description File: a"
    assert one(text).file == "a"


def test_a_view_from_above_shows_as_many_metres_as_in_rviz() -> None:
    current = "{Class: rviz/TopDownOrtho, Scale: 100, X: 1, Y: 2, Angle: 0}"
    manager = f"Visualization Manager: {{Views: {{Current: {current}}}}}"
    camera = read_rviz(f"{manager}\nWindow Geometry: {{Height: 400}}").camera
    assert camera is not None
    assert 2 * camera.distance * math.tan(ANGLE / 2) == pytest.approx(4)
    assert camera.position == pytest.approx((1, 2, camera.distance), abs=0.01)


def test_a_view_that_follows_a_frame_turns_with_it() -> None:
    current = "{Class: rviz/ThirdPersonFollower, Target Frame: base_link}"
    camera = read_rviz(f"Visualization Manager: {{Views: {{Current: {current}}}}}").camera
    assert camera is not None
    assert (camera.target, camera.turns) == ("base_link", True)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "it is not a file of rviz"),
        ("a: [", "it is not YAML"),
        ("[]", "it is not a file of rviz"),
        ("Visualization Manager: 3", "it is not a file of rviz"),
    ],
)
def test_other_texts_are_refused(text: str, reason: str) -> None:
    with pytest.raises(ArrangementError, match=reason):
        read_rviz(text)


def test_a_file_that_is_not_there_is_named(tmp_path: Path) -> None:
    with pytest.raises(ArrangementError, match=r"cannot read .*a\.rviz: No such file"):
        read_rviz_file(tmp_path / "a.rviz")


def test_a_written_file_is_read_as_the_same_arrangement(example: Arrangement) -> None:
    again = read_rviz(rviz_text(example))
    bare = [replace(choice, raw={}) for choice in example.displays]
    assert [replace(choice, raw={}) for choice in again.displays] == bare
    assert replace(again, displays=(), raw={}) == replace(example, displays=(), raw={})


def test_what_the_view_does_not_have_stays_in_the_file(example: Arrangement) -> None:
    written = read_yaml(rviz_text(example))["Visualization Manager"]
    scan, group, other = written["Displays"][1], written["Displays"][2], written["Displays"][-1]
    assert (scan["Decay Time"], scan["Invert Rainbow"]) == (3, True)
    assert scan["Topic"]["Reliability Policy"] == "Best Effort"
    assert group["Name"] == "Navigation"
    assert not group["Enabled"]
    assert other["Topic"] == "/grid_map"


def test_a_frame_that_is_shown_again_is_on_in_the_file(example: Arrangement) -> None:
    tf = example.displays[4]
    shown = replace(tf, values={**tf.values, "hidden": ""})
    text = rviz_text(replace(example, displays=(shown,)))
    assert read_rviz(text).displays[0].values["hidden"] == ""


@pytest.mark.parametrize("kind", sorted(KINDS))
def test_each_display_is_written_and_read_again(kind: str) -> None:
    values: dict[str, Any] = {setting.name: setting.value for setting in KINDS[kind].settings}
    topic = "/a/update" if KINDS[kind].has_topic else ""
    text = rviz_text(Arrangement((DisplayChoice(kind, "a", topic, values=values),)))
    (choice,) = read_rviz(text).displays
    assert (choice.kind, choice.topic) == (kind, topic)
    if kind == "Image":
        values["in the scene"] = False  # rviz draws only what its display Camera shows
    assert choice.values.items() <= values.items()


def test_every_setting_in_the_table_is_one_of_its_display() -> None:
    for known in RVIZ_DISPLAYS.values():
        names = {setting.name for setting in KINDS[known.kind].settings}
        assert {entry.setting for entry in known.entries} <= names


def test_a_camera_is_found_again_from_its_position() -> None:
    camera = Camera((1, 2, 3), 5, 0.5, 0.3)
    found = camera_at(camera.position, camera.focus)
    assert (found.distance, found.yaw, found.pitch) == pytest.approx((5, 0.5, 0.3))


@pytest.mark.parametrize(
    ("package", "file", "frame", "topics"),
    [
        ("nav2_bringup", "nav2_default_view.rviz", "map", {"map", "scan", "plan"}),
        ("urdf_tutorial", "urdf.rviz", "", {"/robot_description"}),
    ],
)
def test_the_files_of_zbot_have_only_what_the_view_has(
    package: str, file: str, frame: str, topics: set[str]
) -> None:
    found = read_rviz_file(package_share(package) / "rviz" / file)
    assert found.misfits == ()
    assert {display.topic for display in found.displays} >= topics
    assert found.fixed_frame == frame


def test_aliases_that_repeat_long_parts_are_refused() -> None:
    start = "Visualization Manager:\n  Displays:\n"
    long = f"  - {{Class: rviz/Grid, Name: &a {'x' * 30_000}}}\n"
    with pytest.raises(ArrangementError, match="aliases repeat too much"):
        read_rviz(start + long + "  - {Class: rviz/Grid, Name: *a}\n" * 1000)
    many = "  - &a {Class: rviz/Grid, Size: [" + "1, " * 5000 + "1]}\n"
    with pytest.raises(ArrangementError, match="aliases stand for more than 100000 values"):
        read_rviz(start + many + "  - *a\n" * 100)
    few = "  - &a {Class: rviz/Grid, Name: abc}\n"
    assert len(read_rviz(start + few + "  - *a\n" * 400).displays) == 401
