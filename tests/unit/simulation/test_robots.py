"""Tests of robots from descriptions: what is found, and what is refused."""

from __future__ import annotations

import math
import struct
from typing import TYPE_CHECKING

import pytest

from tests.unit.simulation.conftest import drive, run, tags_of, turned
from zbot.errors import ZbotError
from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot.simulation.errors import SimulationError
from zbot.simulation.meshes.file import read_points
from zbot.simulation.robots.catalog import find_robot, robot_names
from zbot.simulation.robots.equipment import Battery, Bumper, Camera, Imu, Lidar
from zbot.simulation.robots.model import read_robot
from zbot.simulation.world import World
from zbot.simulation.worlds.plan import Plan

if TYPE_CHECKING:
    from pathlib import Path

    from tests.unit.simulation.conftest import MakeWorld

INERTIA = (
    "<inertial><mass value='1'/>"
    "<inertia ixx='0.01' iyy='0.01' izz='0.01' ixy='0' ixz='0' iyz='0'/></inertial>"
)
CYLINDER = "<collision><geometry><cylinder radius='0.05' length='0.02'/></geometry></collision>"


def link(name: str, content: str = INERTIA) -> str:
    return f"<link name='{name}'>{content}</link>"


def wheel(name: str, y: float, axis: str = "0 1 0", rpy: str = "0 0 0") -> str:
    """Return a wheel that is a cylinder along its axis."""
    flat = "1.5708 0 0" if axis[2] != "0" else "0 0 0"
    shape = CYLINDER.replace("<collision>", f"<collision><origin rpy='{flat}'/>")
    return link(name, INERTIA.replace("0.01'", "0.0001'") + shape) + (
        f"<joint name='{name}_joint' type='continuous'><parent link='base'/><child link='{name}'/>"
        f"<origin xyz='0 {y} 0' rpy='{rpy}'/><axis xyz='{axis}'/></joint>"
    )


CASTER = link(
    "caster",
    "<collision><geometry><sphere radius='0.02'/></geometry></collision>",
) + (
    "<joint name='c' type='fixed'><parent link='base'/><child link='caster'/>"
    "<origin xyz='-0.1 0 -0.03'/></joint>"
)


def robot(*parts: str) -> str:
    return f"<robot name='test'>{''.join(parts)}</robot>"


def world_of(text: str) -> World:
    """Return an empty world with a robot of this description."""
    world = World(Plan().spec())
    world.add([("robot", read_robot(text), turned(0, 0, 0))])
    return world


@pytest.mark.parametrize("name", [name for name in robot_names() if name != "arm"])
def test_each_robot_with_wheels_drives(make_world: MakeWorld, name: str) -> None:
    world = make_world(None, turned(0, 0, 0), robot=name)
    run(world, 0.5)
    drive(world, world.robots["robot1"], 0.3, 0.0, 3.0)
    assert world.robots["robot1"].pose.translation[0] == pytest.approx(0.85, abs=0.12)
    assert abs(world.robots["robot1"].pose.translation[1]) < 0.05


def test_the_two_wheeled_robot_has_all_sensors() -> None:
    kinds = [type(sensor) for sensor in find_robot("two_wheeled").equipment.sensors]
    assert kinds == [Lidar, Imu, Camera, Bumper, Battery]


def test_wheels_and_sensors_are_found_by_their_names() -> None:
    text = robot(
        link("base"),
        wheel("left_wheel", 0.1),
        wheel("right_wheel", -0.1),
        CASTER,
        link("laser_frame"),
        "<joint name='l' type='fixed'><parent link='base'/><child link='laser_frame'/></joint>",
    )
    equipment = read_robot(text).equipment
    assert equipment.drive is not None
    assert (equipment.drive.separation, equipment.drive.radius) == pytest.approx((0.2, 0.05))
    assert equipment.drive.left == ("left_wheel_joint",)
    assert [sensor.link for sensor in equipment.sensors] == ["laser_frame"]


@pytest.mark.parametrize(
    ("axis", "rpy"), [("0 1 0", "0 0 0"), ("0 -1 0", "0 0 0"), ("0 0 1", "-1.5708 0 0")]
)
def test_a_robot_drives_forwards_whatever_the_axes_of_its_wheels_are(axis: str, rpy: str) -> None:
    wheels = (wheel("left_wheel", 0.1, axis, rpy), wheel("right_wheel", -0.1, axis, rpy))
    world = world_of(robot(link("base"), *wheels, CASTER))
    drive(world, world.robots["robot"], 0.3, 0.0, 2.0)
    assert world.robots["robot"].pose.translation[0] > 0.3


def test_gazebo_tags_of_both_generations_are_read() -> None:
    old = tags_of(
        robot(
            "<gazebo reference='base'><mu1 value='0.3'/></gazebo>"
            "<gazebo reference='lidar'><sensor name='a' type='ray'><update_rate>5</update_rate>"
            "<ray><scan><horizontal><samples>180</samples><resolution>1</resolution>"
            "<min_angle>-1.5</min_angle><max_angle>1.5</max_angle></horizontal></scan>"
            "<range><min>0.2</min><max>9</max></range></ray>"
            "<plugin name='b' filename='libgazebo_ros_ray_sensor.so'>"
            "<ros><remapping>~/out:=front_scan</remapping></ros><frame_name>laser</frame_name>"
            "</plugin></sensor></gazebo>"
            "<gazebo><plugin name='c' filename='libgazebo_ros_diff_drive.so'>"
            "<left_joint>l</left_joint><right_joint>r</right_joint>"
            "<wheel_separation>0.3</wheel_separation><wheel_diameter>0.1</wheel_diameter>"
            "<odometry_frame>odom</odometry_frame><robot_base_frame>base</robot_base_frame>"
            "</plugin></gazebo>"
        )
    )
    (sensor,) = old.sensors
    assert isinstance(sensor, Lidar)
    assert (sensor.topic, sensor.frame, sensor.rate_hz, sensor.rays) == (
        "front_scan",
        "laser",
        5,
        180,
    )
    assert (sensor.first_angle, sensor.last_angle) == (-1.5, 1.5)
    assert (sensor.nearest, sensor.farthest) == (0.2, 9)
    assert old.friction == {"base": 0.3}
    assert old.drive is not None
    assert (old.drive.left, old.drive.right, old.drive.radius) == (("l",), ("r",), 0.05)
    new = tags_of(
        robot(
            "<gazebo><plugin filename='gz-sim-diff-drive-system' name='DiffDrive'>"
            "<left_joint>a</left_joint><left_joint>b</left_joint><right_joint>c</right_joint>"
            "<topic>/model/bot/cmd_vel</topic></plugin></gazebo>"
            "<gazebo><plugin filename='fly' name='wings'/></gazebo>"
            "<gazebo reference='x'><sensor type='altimeter'/></gazebo>"
        )
    )
    assert new.drive is not None
    assert (new.drive.left, new.drive.command_topic) == (("a", "b"), "cmd_vel")
    assert new.notices == ("the plugin 'fly'", "a sensor of the type 'altimeter'")


def test_what_the_simulator_does_not_have_is_named(tmp_path: Path) -> None:
    mesh = f"<collision><geometry><mesh filename='{tmp_path}/a.glb'/></geometry></collision>"
    world = world_of(robot(link("base", INERTIA + mesh)))
    assert world.robots["robot"].notices == [
        "the collision of a.glb: only STL, OBJ and COLLADA files collide"
    ]


def stl(*corners: tuple[float, float, float]) -> bytes:
    """Return a binary STL with a triangle for each three corners."""
    triangles = [corners[start : start + 3] for start in range(0, len(corners), 3)]
    rows = (
        struct.pack("<12fH", 0, 0, 0, *(part for corner in rows for part in corner), 0)
        for rows in triangles
    )
    return bytes(80) + struct.pack("<I", len(triangles)) + b"".join(rows)


TETRAHEDRON = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 0), (1, 0, 0), (0, 0, 1))


def test_a_robot_collides_with_the_hull_of_its_mesh(tmp_path: Path) -> None:
    (tmp_path / "a.stl").write_bytes(stl(*TETRAHEDRON))
    shape = f"<mesh filename='file://{tmp_path}/a.stl' scale='0.5 0.5 0.5'/>"
    content = f"<collision><geometry>{shape}</geometry></collision>"
    world = world_of(robot(link("base", INERTIA + content)))
    run(world, 0.5)
    assert world.robots["robot"].pose.translation[2] == pytest.approx(0.0, abs=0.01)


def test_points_are_read_from_text_and_binary_files(tmp_path: Path) -> None:
    (tmp_path / "a.stl").write_bytes(stl(*TETRAHEDRON))
    (tmp_path / "b.stl").write_text("solid a\nfacet\nouter loop\nvertex 1 2 3\nendloop\n")
    (tmp_path / "c.obj").write_text("# comment\nv 1 2 3\nvn 0 0 1\nf 1 1 1\n")
    assert len(read_points(tmp_path / "a.stl")) == 4
    assert read_points(tmp_path / "b.stl").tolist() == [[1, 2, 3]]
    assert read_points(tmp_path / "c.obj").tolist() == [[1, 2, 3]]


MANY_LINKS = robot(
    *(link(f"l{number}") for number in range(10_000)),
    *(
        f"<joint name='j{number}' type='fixed'><parent link='l0'/><child link='l{number}'/></joint>"
        for number in range(1, 10_000)
    ),
)
MANY_JOINTS = MANY_LINKS.replace("10000", "150").replace("'fixed'", "'continuous'")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (MANY_LINKS, "has 10000 links: the limit is 1000"),
        (robot(link("a", INERTIA.replace("'1'", "'nan'"))), "must be a number, not 'nan'"),
        (robot(link("a", INERTIA.replace("'1'", "'-1'"))), "a mass or a moment below 0"),
        (robot(link("a", INERTIA.replace("'1'", "'1e99'"))), "its mass is 1e+99 kg"),
        (
            robot(link("a", INERTIA.replace("0.01'", "0'"))),
            "its moments of inertia are 0 to 0 kg m^2",
        ),
        (robot(link("a", "")), "its mass is 0 kg: give it an <inertial>"),
        (
            robot(
                link(
                    "a",
                    INERTIA
                    + CYLINDER.replace(
                        "<cylinder radius='0.05' length='0.02'/>",
                        "<mesh filename='package://../..'/>",
                    ),
                )
            ),
            "package://../.. is not found",
        ),
        (
            robot(
                link(
                    "a",
                    INERTIA
                    + CYLINDER.replace(
                        "<cylinder radius='0.05' length='0.02'/>",
                        "<mesh filename='/nowhere/a.stl'/>",
                    ),
                )
            ),
            "cannot be read",
        ),
        (
            robot(
                link("base"),
                "<gazebo><plugin filename='libgazebo_ros_diff_drive.so'><left_joint>a</left_joint>"
                "<right_joint>b</right_joint></plugin></gazebo>",
            ),
            "the drive names the joint 'a', which does not exist",
        ),
        ("<robot name='a'><link name='b'/><link name='c'/></robot>", "both have no parent"),
        ("<!DOCTYPE a [<!ENTITY b 'c'>]><robot name='a'>&b;</robot>", "must not define entities"),
    ],
)
def test_a_robot_that_cannot_be_simulated_is_told_in_one_sentence(text: str, said: str) -> None:
    with pytest.raises(ZbotError) as caught:
        world_of(text)
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


def test_the_world_goes_on_after_a_refused_robot(make_world: MakeWorld) -> None:
    world = make_world(None, turned(0, 0, 0))
    with pytest.raises(SimulationError):
        world.add([("broken", read_robot(robot(link("a", ""))), turned(1, 1, 0))])
    assert list(world.robots) == ["robot1"]
    drive(world, world.robots["robot1"], 0.3, 0.0, 1.0)
    assert world.robots["robot1"].pose.translation[0] > 0.2


def test_a_large_mesh_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.stl"
    with path.open("wb") as file:
        file.truncate(10**9)
    with pytest.raises(SimulationError, match="more than 50 MB"):
        read_points(path)


def test_a_flat_mesh_becomes_a_thin_plate(tmp_path: Path) -> None:
    (tmp_path / "a.stl").write_bytes(stl((0, 0, 0), (1, 0, 0), (0, 1, 0)))
    shape = f"<mesh filename='file://{tmp_path}/a.stl'/>"
    content = f"<collision><geometry>{shape}</geometry></collision>"
    world = world_of(robot(link("base", INERTIA + content)))
    assert world.model.geom_aabb[-1][3:].min() == pytest.approx(0.005, abs=1e-6)


def test_a_mesh_without_a_surface_is_left_out_and_infinite_points_are_refused(
    tmp_path: Path,
) -> None:
    shape = f"<mesh filename='file://{tmp_path}/a.stl'/>"
    content = f"<collision><geometry>{shape}</geometry></collision>"
    (tmp_path / "a.stl").write_bytes(stl((0, 0, 0), (1, 0, 0), (2, 0, 0)))
    world = world_of(robot(link("base", INERTIA + content)))
    (made,) = world.robots.values()
    assert made.notices == ["the collision of a.stl, which has no surface,"]
    (tmp_path / "a.stl").write_bytes(stl(*TETRAHEDRON[:5], (0, 0, math.inf)))
    with pytest.raises(SimulationError, match="not within 10 km"):
        world_of(robot(link("base", INERTIA + content)))


def test_tags_that_have_no_effect_are_named_in_one_line() -> None:
    tags = (
        "<gazebo reference='base'><mu1 value='0.3'/><mu2>0.9</mu2><fdir1>1 0 0</fdir1><kp>1e6</kp>"
        "<minDepth>0.01</minDepth><selfCollide>true</selfCollide><plugin name='p'><kd>1</kd>"
        "</plugin><turnGravityOff>false</turnGravityOff></gazebo>"
    )
    same = "<gazebo reference='base'><mu1>0.3</mu1><mu2>0.3</mu2><fdir1>1 0 0</fdir1></gazebo>"
    said = "what <fdir1>, <kp>, <minDepth>, <mu2>, <selfCollide> say"
    for text, expected in ((tags, said), (same, "")):
        notices = read_robot(robot(link("base", INERTIA), text)).equipment.notices
        found = [notice for notice in notices if notice.startswith("what ")]
        assert found == ([expected] if expected else [])


def test_an_unknown_robot_gets_a_suggestion(tmp_path: Path) -> None:
    with pytest.raises(SimulationError, match="did you mean 'two_wheeled'"):
        find_robot("two_weeled")
    with pytest.raises(DescriptionError, match="cannot be read"):
        find_robot(str(tmp_path / "a.urdf"))


def test_a_description_with_macros_is_expanded(tmp_path: Path) -> None:
    pytest.importorskip("xacro")
    path = tmp_path / "a.urdf.xacro"
    path.write_text(
        "<robot name='a' xmlns:xacro='http://www.ros.org/wiki/xacro'>"
        "<xacro:property name='n' value='base'/><link name='${n}'/></robot>"
    )
    assert find_robot(str(path)).tree.root == "base"
    path.write_text("<robot name='a' xmlns:xacro='http://www.ros.org/wiki/xacro'>${</robot>")
    with pytest.raises(SimulationError, match="xacro cannot read"):
        find_robot(str(path))
