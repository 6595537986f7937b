"""Displays make shapes from messages, and a sentence from messages that cannot be drawn."""

from __future__ import annotations

import copy
import math
from typing import Any

import numpy as np
import pytest
from map_msgs.msg import OccupancyGridUpdate

import zbot  # noqa: F401 - makes the messages importable
from tests.conftest import wait_until
from tests.unit.view import messages
from tests.unit.view.messages import MESSAGES, cloud, framed, grid, marker, path, scan
from zbot.interfaces import get_message
from zbot.tf2.rigid import Rigid
from zbot.view.displays import DISPLAYS, display_for
from zbot.view.displays.grid import Axes as AxesAtFrame
from zbot.view.displays.grid import Grid
from zbot.view.displays.image import Image
from zbot.view.displays.laser_scan import LaserScan
from zbot.view.displays.map import Map
from zbot.view.displays.marker import Marker, MarkerArray
from zbot.view.displays.path import Path
from zbot.view.displays.point_cloud import PointCloud2
from zbot.view.displays.pose import Odometry, Pose, PoseWithCovariance
from zbot.view.displays.robot_model import RobotModel
from zbot.view.displays.text import Text
from zbot.view.displays.tf import TF
from zbot.view.errors import DisplayError
from zbot.view.frames import Tree
from zbot.view.shape import (
    Arrows,
    Axes,
    Copies,
    Frustum,
    Label,
    Lines,
    Mesh,
    Note,
    Picture,
    Plane,
    Points,
)

from geometry_msgs.msg import Point, Quaternion
from sensor_msgs.msg import CameraInfo, CompressedImage
from std_msgs.msg import ColorRGBA, String
from visualization_msgs.msg import Marker as MarkerMessage
from visualization_msgs.msg import MarkerArray as MarkerArrayMessage

NAN = math.nan


def only(display: Any, message: Any) -> Any:
    """Return the only shape of a message."""
    display.take(message)
    ((shape,),) = [item.shapes for item in display.items.values()]
    return shape


def shapes(display: Any) -> tuple[Any, ...]:
    """Return the shapes of the first item."""
    return tuple(next(iter(display.items.values())).shapes)


def test_each_type_of_a_display_exists() -> None:
    for display in DISPLAYS:
        for name in display.types:
            assert get_message(name).__name__ == name.rpartition("/")[2]


def test_colours_are_settings() -> None:
    display = LaserScan("/scan")
    display.values["color"] = (0, 0, 255)
    assert only(display, scan([1.0])).colors.tolist() == [[0, 0, 255]]


def test_a_grid_has_lines_in_its_plane() -> None:
    display = Grid("")
    display.values.update(cells=2.0, plane="XZ", height=1.0)
    display.tick(0)
    (lines,) = shapes(display)
    assert len(lines.ends) == 6
    assert set(lines.ends[..., 1].ravel()) == {1.0}
    assert lines.ends.min() == -1.0


def test_axes_are_at_their_frame() -> None:
    display = AxesAtFrame("")
    display.change("frame", "/tool")
    display.tick(0)
    assert [item.frame for item in display.items.values()] == ["tool"]


def test_hidden_frames_are_not_shown() -> None:
    display = TF("")
    display.values["hidden"] = "odom, laser"
    display.follow(Tree({"base": "odom", "laser": "base"}, {"odom": Rigid(), "base": Rigid()}))
    assert set(display.items) == {"", "name base"}
    axes = shapes(display)[0]
    assert len(axes.poses) == 1


def test_hidden_namespaces_of_markers_are_not_shown() -> None:
    display = MarkerArray("/marks")
    display.take(MarkerArrayMessage(markers=[marker(1, ns="a"), marker(1, ns="b")]))
    display.change("hidden", "a")
    display.take(MarkerArrayMessage(markers=[marker(1, ns="a", id=2)]))
    assert list(display.items) == ["b/0"]


def test_a_path_may_have_arrows() -> None:
    display = Path("/plan")
    display.values["poses"] = "arrow"
    display.take(path(0, 1, 2))
    line, arrows = shapes(display)
    assert (len(line.ends), len(arrows.ends)) == (2, 3)


def test_a_map_may_be_seen_through() -> None:
    display = Map("/map")
    display.values["opacity"] = 0.5
    assert only(display, grid(1, 1, [0])).pixels.tolist() == [[[255, 255, 255, 127]]]


def test_other_texts_than_robot_descriptions_are_not_shown() -> None:
    assert display_for("/chatter", "std_msgs/msg/String") is None
    assert display_for("/robot_1/robot_description", "std_msgs/msg/String") is RobotModel


def test_a_scan_becomes_points_without_invalid_rays() -> None:
    points = only(LaserScan("/scan"), scan([1.0, NAN, math.inf, 20.0, 0.01, 2.0]))
    assert points.positions == pytest.approx(
        np.array([(1, 0, 0), (2 * math.cos(2.5), 2 * math.sin(2.5), 0)]), abs=1e-6
    )


def test_a_scan_without_intensities_says_so() -> None:
    display = LaserScan("/scan")
    display.values["color by"] = "intensity"
    only(display, scan([1.0]))
    assert display.notice == "the scan has no intensities"


def test_a_cloud_has_the_colours_of_its_points() -> None:
    points = only(PointCloud2("/cloud"), cloud([(1, 2, 3, 0xFF8000), (NAN, 0, 0, 0)]))
    assert points.positions.tolist() == [[1, 2, 3]]
    assert points.colors.tolist() == [[255, 128, 0]]


def test_a_cloud_is_coloured_by_an_axis() -> None:
    display = PointCloud2("/cloud")
    display.values["color by"] = "x"
    points = only(display, cloud([(0, 0, 0, 0), (1, 0, 0, 0)]))
    assert points.colors.tolist() == [[255, 0, 0], [255, 0, 255]]


def test_a_large_cloud_is_thinned_and_says_so() -> None:
    display = PointCloud2("/cloud")
    display.values["points at most"] = 1000
    points = only(display, cloud([(1, 2, 3, 0)] * 2500))
    assert len(points.positions) == 834
    assert display.notice == "834 of 2500 points are shown"


def test_a_path_becomes_a_line() -> None:
    lines = only(display_for("/plan", "nav_msgs/msg/Path")("/plan"), path(0, 1, 3))  # type: ignore[misc]
    assert lines.ends[:, :, 0].tolist() == [[0, 1], [1, 3]]


def test_a_pose_becomes_an_arrow_or_axes() -> None:
    display = Pose("/goal_pose")
    arrow = only(display, MESSAGES["Pose"])
    assert isinstance(arrow, Arrows)
    assert arrow.ends[0, :, 0].tolist() == [1, 1.5]
    display.values["shape"] = "axes"
    assert isinstance(only(display, MESSAGES["Pose"]), Axes)


def test_a_covariance_becomes_an_ellipse() -> None:
    display = PoseWithCovariance("/pose")
    display.take(MESSAGES["PoseWithCovariance"])
    _, ellipse = display.items[""].shapes
    assert isinstance(ellipse, Lines)
    assert np.abs(ellipse.ends[:, :, 0]).max() == pytest.approx(0.2 * math.sqrt(5.99), rel=0.01)


def test_odometry_draws_the_line_of_a_robot_that_moves() -> None:
    display = Odometry("/odom")
    for x in (0.0, 0.0, 1.0, 2.0):
        message = framed(copy.deepcopy(MESSAGES["Odometry"]), "odom")
        message.pose.pose.position.x = x
        display.take(message)
    line = display.items[""].shapes[-1]
    assert isinstance(line, Lines)
    assert line.ends[:, :, 0].tolist() == [[0, 1], [1, 2]]


def test_a_map_has_the_size_and_the_colours_of_its_cells() -> None:
    plane = only(Map("/map"), grid(2, 2, [0, 100, -1, 50]))
    assert (plane.width, plane.height) == (1, 1)
    assert plane.pose.translation == pytest.approx((0.5, 0.5, -0.01))
    # The first row of the picture is the last of the map.
    assert plane.pixels[:, :, 0].tolist() == [[112, 128], [255, 0]]


def test_a_costmap_is_recognized_by_its_name() -> None:
    plane = only(Map("/global_costmap/costmap"), grid(1, 1, [100]))
    assert plane.pixels.tolist() == [[[255, 0, 255]]]


def test_the_colours_of_a_map_change_without_a_new_map() -> None:
    display = Map("/map")
    display.change("color", "costmap")
    display.change("color", "map")
    display.take(grid(1, 1, [100]))
    display.change("color", "costmap")
    (plane,) = display.items[""].shapes
    assert isinstance(plane, Plane)
    assert plane.pixels.tolist() == [[[255, 0, 255]]]


def test_an_update_changes_a_part_of_a_map() -> None:
    display = Map("/map")
    assert list(display.more_topics) == ["/map_updates"]
    display.take(grid(2, 2, [0, 0, 0, 0]))
    plane = only(display, OccupancyGridUpdate(x=1, y=0, width=1, height=1, data=[100]))
    assert plane.pixels[:, :, 0].tolist() == [[255, 255], [255, 0]]


def test_an_update_outside_of_the_map_is_refused() -> None:
    display = Map("/map")
    with pytest.raises(DisplayError, match="before the first whole map"):
        display.take(OccupancyGridUpdate())
    display.take(grid(2, 2, [0, 0, 0, 0]))
    with pytest.raises(DisplayError, match="does not fit into the map of 2x2"):
        display.take(OccupancyGridUpdate(x=2, y=0, width=1, height=1, data=[100]))


POINTS = [Point(x=float(x)) for x in range(6)]


@pytest.mark.parametrize(
    ("message", "kind"),
    [
        (marker(0), Arrows),
        (marker(0, points=POINTS[:2]), Arrows),
        (marker(1), Mesh),
        (marker(2), Mesh),
        (marker(3), Mesh),
        (marker(4, points=POINTS), Lines),
        (marker(5, points=POINTS), Lines),
        (marker(6, points=POINTS), Copies),
        (marker(7, points=POINTS), Copies),
        (marker(8, points=POINTS), Points),
        (marker(9, text="hello"), Label),
        (marker(11, points=POINTS), Mesh),
        (marker(12, points=POINTS), Arrows),
    ],
)
def test_each_kind_of_marker_is_drawn(message: Any, kind: type) -> None:
    assert isinstance(only(Marker("/marker"), message), kind)


@pytest.mark.parametrize(
    ("message", "reason"),
    [
        (marker(99), "marker /0: it has the unknown type 99"),
        (marker(4, points=POINTS[:1]), "it has 1 points, but needs at least 2"),
        (marker(5, points=POINTS[:3]), "it has 3 points, but needs a multiple of 2"),
        (marker(0, points=POINTS[:3]), "needs 0 or 2"),
        (marker(8), "it has 0 points"),
        (marker(9), "it has no text"),
        (marker(8, points=POINTS, colors=[messages.RED]), "1 colors for 6 points"),
        (marker(8, points=[Point(x=NAN)]), "a number of points is NaN"),
        (marker(1, action=7), "the unknown action 7"),
        (marker(1, color=ColorRGBA()), "color.a is 0"),
        (framed(MarkerMessage(type=1, color=messages.RED)), "scale.x and scale.y and scale.z must"),
    ],
)
def test_a_marker_that_cannot_be_drawn_says_why(message: Any, reason: str) -> None:
    display = Marker("/marker")
    with pytest.raises(DisplayError, match=reason):
        display.take(message)


def test_a_marker_whose_file_is_missing_says_so() -> None:
    display = Marker("/marker")
    message = marker(10, mesh_resource="https://example.com/a.stl")
    mistakes: list[str] = []

    def look() -> bool:
        try:
            display.take(message)
        except DisplayError as error:
            mistakes.append(str(error))
        return bool(mistakes)

    assert wait_until(look)  # a thread reads the file
    assert mistakes[0].startswith("marker /0: https://example.com/a.stl cannot be read")


def test_markers_are_changed_and_deleted_by_namespace_and_id() -> None:
    display = MarkerArray("/markers")
    display.take(MarkerArrayMessage(markers=[marker(1, ns="a", id=1), marker(1, ns="b", id=1)]))
    display.take(MarkerArrayMessage(markers=[marker(2, ns="a", id=1), marker(1, ns="a", id=2)]))
    assert sorted(display.items) == ["a/1", "a/2", "b/1"]
    display.take(MarkerArrayMessage(markers=[marker(1, ns="a", id=1, action=2)]))
    assert sorted(display.items) == ["a/2", "b/1"]
    display.take(MarkerArrayMessage(markers=[MarkerMessage(action=3)]))
    assert display.items == {}


def test_a_marker_with_a_lifetime_disappears() -> None:
    display = Marker("/marker")
    message = marker(1)
    message.lifetime.sec = 2
    display.tick(10**9)
    display.take(message)
    display.tick(2 * 10**9)
    assert len(display.items) == 1
    display.tick(3 * 10**9)
    assert display.items == {}


def test_an_array_shows_its_other_markers_if_one_is_wrong() -> None:
    display = MarkerArray("/markers")
    with pytest.raises(DisplayError, match="marker /7: it has no text"):
        display.take(MarkerArrayMessage(markers=[marker(9, id=7), marker(1, id=8)]))
    assert list(display.items) == ["/8"]


def test_a_picture_is_drawn_in_what_the_camera_sees() -> None:
    display = Image("/camera/image_raw")
    assert list(display.more_topics) == ["/camera/camera_info"]
    display.take(MESSAGES["Image"])
    (picture,) = display.items[""].shapes
    assert isinstance(picture, Picture)
    assert picture.media_type == "image/jpeg"
    display.take(CameraInfo(height=200, k=[100.0, 0, 0, 0, 100.0, 0, 0, 0, 1]))
    display.take(MESSAGES["Image"])
    _, frustum = display.items[""].shapes
    assert isinstance(frustum, Frustum)
    assert frustum.vertical_angle == pytest.approx(math.pi / 2)
    assert display.items[""].frame == "map"


def test_a_sensor_is_shown_as_text() -> None:
    note = only(Text("/temperature"), MESSAGES["Text"])
    assert isinstance(note, Note)
    assert note.text == "21.50 °C"


URDF = """<robot name='r'>
  <material name='red'><color rgba='1 0 0 0.5'/></material>
  <link name='base'>
    <visual><origin xyz='0 0 1'/><geometry><box size='1 2 3'/></geometry>
      <material name='red'/></visual>
    <visual><geometry><sphere radius='1'/></geometry></visual>
    <collision><geometry><cylinder radius='1' length='4'/></geometry></collision>
  </link></robot>"""


def test_a_robot_is_drawn_link_by_link() -> None:
    display = RobotModel("/robot_description")
    display.take(String(data=URDF))
    assert display.items["base"].frame == "base"
    box, sphere = display.items["base"].shapes
    assert isinstance(box, Mesh)
    assert isinstance(sphere, Mesh)
    assert box.vertices.max(axis=0).tolist() == [0.5, 1, 1.5]
    assert (box.color, box.opacity, box.pose) == ((255, 0, 0), 0.5, Rigid((0, 0, 1)))
    assert np.abs(sphere.vertices).max() == pytest.approx(1, abs=0.02)
    display.values["part"] = "collision"
    cylinder = only(display, String(data=URDF))
    assert cylinder.vertices.max(axis=0) == pytest.approx([1, 1, 2])


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "the robot description is not valid"),
        ("<robot name='r'><link name='a'/></robot>", "no link of the robot description has"),
        (URDF.replace("box size='1 2 3'", "box size='1 nan 3'"), "must be 3 numbers"),
        (URDF.replace("sphere", "blob"), "unknown shape <blob>"),
    ],
)
def test_a_robot_that_cannot_be_drawn_says_why(text: str, reason: str) -> None:
    with pytest.raises(DisplayError, match=reason):
        RobotModel("/robot_description").take(String(data=text))


def test_frames_become_axes_lines_and_names() -> None:
    display = TF("/tf")
    tree = Tree({"base": "odom"}, {"odom": Rigid(), "base": Rigid((1, 0, 0))})
    display.follow(tree)
    axes, lines = display.items[""].shapes
    assert isinstance(axes, Axes)
    assert isinstance(lines, Lines)
    assert lines.ends[0].tolist() == [[1, 0, 0], [0, 0, 0]]
    before = display.items
    display.follow(tree)
    assert display.items is before  # nothing is sent
    display.values["names"] = False
    display.follow(tree)
    assert list(display.items) == [""]


@pytest.mark.parametrize("name", [name for name in MESSAGES if name != "Text"])
def test_each_display_refuses_a_message_without_a_frame(name: str) -> None:
    message = framed(copy.deepcopy(MESSAGES[name]), "")
    display = next(kind for kind in DISPLAYS if kind.name == name)("/topic")
    if name == "Image":
        display.take(CameraInfo(height=200, k=[100.0, 0, 0, 0, 100.0, 0, 0, 0, 1]))
    with pytest.raises(DisplayError, match="the message names no frame"):
        display.take(message)


def _turned(message: Any) -> Any:
    message = copy.deepcopy(message)
    message.pose.orientation = Quaternion(x=3.0)
    return message


@pytest.mark.parametrize(
    ("name", "message", "reason"),
    [
        ("LaserScan", scan([]), "the scan is empty"),
        ("LaserScan", scan([1.0], angle_min=NAN), "is not finite"),
        ("PointCloud2", cloud([(0, 0, 0, 0)], width=1000), "needs 16000 bytes, but it has 16"),
        ("PointCloud2", cloud([(0, 0, 0, 0)], width=2**32 - 1, height=2**32 - 1), "but it has 16"),
        ("PointCloud2", cloud([(0, 0, 0, 0)], fields=[]), "the cloud has no field 'x'"),
        ("PointCloud2", cloud([(0, 0, 0, 0)], point_step=1), "the cloud cannot be read"),
        ("Map", grid(0, 0, []), "the map is empty"),
        ("Map", grid(3, 1, [0]), "has 1 values for 3x1 = 3 cells"),
        ("Map", grid(10**6, 10**6, []), "the limit is 100000000"),
        ("Map", grid(1, 1, [0], resolution=0.0), "info.resolution is 0"),
        ("Map", grid(1, 1, [0], resolution=NAN), "info.resolution is nan"),
        ("Path", path(0, NAN), "a number of the path is NaN"),
        ("Pose", _turned(MESSAGES["Pose"]), "not a quaternion of length 1"),
        ("Polygon", messages.polygon((NAN, 0), (1, 1)), "a number of the polygon is NaN"),
        ("Image", framed(CompressedImage(format="jpeg", data=b"nothing")), "use JPEG, PNG"),
        ("Image", framed(type(messages.image())(encoding="what", width=1, height=1)), "cannot be"),
    ],
)
def test_a_message_that_cannot_be_drawn_says_why(name: str, message: Any, reason: str) -> None:
    display = next(kind for kind in DISPLAYS if kind.name == name)("/topic")
    with pytest.raises(DisplayError, match=reason):
        display.take(message)


@pytest.mark.parametrize("name", ["LaserScan", "PointCloud2"])
def test_messages_stay_for_their_decay_time(name: str) -> None:
    display = next(kind for kind in DISPLAYS if kind.name == name)("/topic")
    display.change("decay time", 2.0)
    for second in range(4):
        display.take(MESSAGES[name])
        display.tick(second * 10**9)
    assert len(display.items) == 2
    display.tick(10 * 10**9)
    assert not display.items
    display.change("decay time", 0.0)
    display.take(MESSAGES[name])
    display.take(MESSAGES[name])
    assert len(display.items) == 1
