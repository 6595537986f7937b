"""Tests of worlds and models in SDF."""

from __future__ import annotations

import itertools
import math
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from zbot.errors import ZbotError
from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot.simulation.errors import SimulationError
from zbot.simulation.node.markers import WorldMarkers
from zbot.simulation.robots.equipment import Camera, Gps, TruePose
from zbot.simulation.robots.model import GazeboPlace, RobotModel, read_robot
from zbot.simulation.sdf.resources import find_resource
from zbot.simulation.sdf.robot import model_of, robot_of
from zbot.simulation.sdf.world import sdf_world
from zbot.simulation.sensors.gps import GpsReceiver
from zbot.simulation.world import World
from zbot.simulation.worlds.plan import Plan
from zbot.tf2.rigid import Rigid

if TYPE_CHECKING:
    from pathlib import Path


BOX = "<geometry><box><size>{0}</size></box></geometry>"
FLOOR = "<include><uri>model://ground_plane</uri></include>"


def collision(size: str, pose: str = "") -> str:
    """Return a box that collides."""
    placed = f"<pose>{pose}</pose>" if pose else ""
    return f"<collision name='c'>{placed}{BOX.format(size)}</collision>"


def world_of(folder: Path, content: str, version: str = "1.9") -> tuple[World, Any]:
    """Return a world in SDF, and what was read."""
    path = folder / "a.world"
    path.write_text(f"<sdf version='{version}'><world name='w'>{content}</world></sdf>")
    found = sdf_world(path)
    return World(found.spec), found


def distance(world: World, origin: tuple[float, float, float], ray: tuple[float, ...]) -> float:
    """Return how far a ray goes."""
    distances, _, _ = world.cast(np.array(origin), np.array([ray], float))
    return float(distances[0])


def robot(content: str, name: str = "bot") -> tuple[RobotModel, Rigid]:
    """Return a robot in SDF."""
    text = f"<sdf version='1.9'><model name='{name}'>{content}</model></sdf>"
    return robot_of(model_of(text), GazeboPlace(name, "w"))


def test_a_camera_with_depth_has_the_points_of_gazebo() -> None:
    sensor = "<sensor name='c' type='{}'><topic>eye</topic></sensor>"
    for kind, topic in (
        ("rgbd_camera", "gz-transport:/eye/points"),
        ("depth_camera", "gz-transport:/eye/points"),
        ("camera", ""),
    ):
        model, _ = robot(f"<link name='l'>{sensor.format(kind)}</link>")
        (camera,) = model.equipment.sensors
        assert isinstance(camera, Camera)
        assert camera.points_topic == topic


def test_hills_are_as_high_as_the_image_of_their_heightmap(tmp_path: Path) -> None:
    # The upper row of the image is at the largest y. White is 5 m high.
    (tmp_path / "hills.pgm").write_bytes(
        b"P5 3 3 255\n" + bytes([51, 51, 255, 51, 51, 51, 0, 51, 51])
    )
    shape = "<heightmap><uri>hills.pgm</uri><size>20 20 5</size><pos>0 0 1</pos></heightmap>"
    model = (
        "<model name='m'><static>1</static><link name='l'><collision name='c'>"
        f"<geometry>{shape}</geometry></collision></link></model>"
    )
    world, found = world_of(tmp_path, model)
    assert not found.notices
    for x, y, height in ((9.99, 9.99, 6), (-9.99, -9.99, 1), (0, 0, 2), (-9.99, 9.99, 2)):
        assert 50 - distance(world, (x, y, 50.0), (0, 0, -1)) == pytest.approx(height, abs=0.02)
    (marker,) = WorldMarkers(world).fixed().markers[1:]
    highest = max(marker.points, key=lambda point: point.z)
    assert (highest.x, highest.y, highest.z) == pytest.approx((10, 10, 5))
    assert len(marker.points) == 4 * 2 * 3


def test_a_heightmap_that_cannot_be_used_is_refused(tmp_path: Path) -> None:
    model = (
        "<model name='m'><static>1</static><link name='l'><collision name='c'><geometry><heightmap>"
        "<uri>{}</uri><size>{}</size></heightmap></geometry></collision></link></model>"
    )
    with (tmp_path / "large.pgm").open("wb") as file:
        file.truncate(10**9)
    (tmp_path / "one.pgm").write_bytes(b"P5 1 1 255\n\0")
    for name, size, said in (
        ("large.pgm", "1 1 1", "has more than"),
        ("one.pgm", "1 1 1", "more than one row"),
        ("one.pgm", "1e308 1 1", "has the size"),
    ):
        with pytest.raises(SimulationError, match=said):
            world_of(tmp_path, model.format(name, size))
    _, found = world_of(tmp_path, model.format("missing.pgm", "1 1 1"))
    assert found.notices == ["the heightmap missing.pgm, which is not on this machine,"]


def test_a_world_says_where_it_is_on_the_earth(tmp_path: Path) -> None:
    place = "<latitude_deg>47.5</latitude_deg><longitude_deg>8.5</longitude_deg>"
    _, found = world_of(tmp_path, f"<spherical_coordinates>{place}</spherical_coordinates>")
    assert found.earth == (47.5, 8.5, 0.0)
    bot, _ = robot("<link name='l'><sensor name='g' type='navsat'/></link>")
    world = World(found.spec, earth=found.earth)
    (made,) = world.add([("r", bot, Rigid())])
    (gps,) = bot.equipment.sensors
    assert isinstance(gps, Gps)
    fix = GpsReceiver(gps, made, 0).measure(world)
    assert (fix.latitude, fix.longitude) == pytest.approx((47.5, 8.5), abs=1e-6)


def test_models_stand_where_nested_frames_place_them(tmp_path: Path) -> None:
    world, _ = world_of(
        tmp_path,
        "<model name='a'><static>1</static><pose>1 0 0 0 0 1.5707963</pose>"
        "<frame name='f'><pose>1 0 0 0 0 0</pose></frame>"
        "<link name='x'><pose relative_to='f'>1 0 0.5 0 0 0</pose>" + collision("1 1 1") + "</link>"
        "<model name='inner'><pose>-2 0 0 0 0 0</pose><link name='y'>"
        + collision("1 1 1", "0 0 0.5 0 0 0")
        + "</link></model></model>",
    )
    assert distance(world, (1, 0, 0.5), (0, 1, 0)) == pytest.approx(1.5)
    assert distance(world, (1, 0, 0.5), (0, -1, 0)) == pytest.approx(1.5)
    assert not world.things


def test_a_thing_falls_on_the_floor_and_has_its_own_mass(tmp_path: Path) -> None:
    inertia = "<ixx>0.02</ixx><iyy>0.02</iyy><izz>0.02</izz>"
    world, _ = world_of(
        tmp_path,
        FLOOR + "<model name='crate'><pose>0 0 1 0 0 0</pose><link name='x'><inertial><mass>2"
        f"</mass><inertia>{inertia}</inertia></inertial>" + collision("0.4 0.4 0.4") + "</link>"
        "</model>",
    )
    crate = world.things["crate"]
    assert world.model.body_mass[crate.root] == 2
    for _ in range(500):
        world.step()
    assert crate.pose.translation[2] == pytest.approx(0.2, abs=0.01)


def test_a_door_turns_about_the_place_of_its_joint(tmp_path: Path) -> None:
    hinge = "<parent>frame</parent><child>leaf</child><pose>-0.5 0 0 0 0 0</pose>"
    world, _ = world_of(
        tmp_path,
        "<gravity>0 0 0</gravity><model name='door'><link name='frame'>"
        + collision("0.1 0.1 2", "-0.6 0 0 0 0 0")
        + "</link><joint name='fix' type='fixed'><parent>world</parent><child>frame</child></joint>"
        "<link name='leaf'><inertial><mass>1</mass></inertial>"
        + collision("0.9 0.05 2")
        + "</link>"
        f"<joint name='hinge' type='revolute'>{hinge}<axis><xyz>0 0 1</xyz></axis></joint></model>",
    )
    joint = world.model.joint("door/hinge")
    world.data.qpos[joint.qposadr[0]] = math.pi / 2
    world.refresh()
    (leaf,) = (at for at in range(world.model.ngeom) if "leaf" in world.model.geom(at).name)
    assert world.data.geom_xpos[leaf][:2] == pytest.approx([-0.5, 0.5], abs=1e-6)


def test_a_wall_around_a_room_leaves_the_room_free(tmp_path: Path) -> None:
    ring = []
    for inner, turn in ((2.0, 1), (2.2, -1)):
        corners = [
            (
                inner * math.cos((step + 0.5) * math.pi / 4),
                inner * math.sin((step + 0.5) * math.pi / 4),
            )
            for step in range(9)
        ]
        for (ax, ay), (bx, by) in itertools.pairwise(corners):
            quad = [(ax, ay, 0), (bx, by, 0), (bx, by, 1), (ax, ay, 1)][::turn]
            ring.append("".join(f"v {x} {y} {z}\n" for x, y, z in quad) + "f -4 -3 -2 -1\n")
    (tmp_path / "ring.obj").write_text("".join(ring))
    mesh = "<geometry><mesh><uri>ring.obj</uri></mesh></geometry>"
    content = f"<model name='r'><static>1</static><link name='x'><collision name='c'>{mesh}"
    world, found = world_of(tmp_path, content + "</collision></link></model>")
    assert found.notices == []
    assert distance(world, (0, 0, 0.5), (1, 0, 0)) == pytest.approx(1.848, abs=0.02)
    assert distance(world, (3, 0, 0.5), (-1, 0, 0)) == pytest.approx(0.967, abs=0.02)


COLLADA = """<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema"><asset>
<unit meter="0.5"/><up_axis>Y_UP</up_axis></asset><library_geometries><geometry id="g"><mesh>
<source id="p"><float_array count="12">0 0 0 2 0 0 0 2 0 0 0 2</float_array></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/>
<p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene><node><translate>0 2 0</translate>
<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes></COLLADA>"""


def test_a_collada_file_has_metres_and_z_upwards(tmp_path: Path) -> None:
    (tmp_path / "a.dae").write_text(COLLADA)
    mesh = "<geometry><mesh><uri>a.dae</uri></mesh></geometry>"
    content = f"<model name='r'><static>1</static><link name='x'><collision name='c'>{mesh}"
    world, _ = world_of(tmp_path, content + "</collision></link></model>")
    assert distance(world, (0.1, -0.1, 5), (0, 0, -1)) == pytest.approx(5 - 1.8, abs=0.02)
    assert distance(world, (0.1, -0.1, 0), (0, 0, 1)) == pytest.approx(1.0, abs=0.02)


def test_included_models_are_found_by_the_path_of_models(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "models" / "crate"
    folder.mkdir(parents=True)
    (folder / "model.config").write_text("<model><sdf version='1.5'>crate.sdf</sdf></model>")
    (folder / "crate.sdf").write_text(
        "<sdf version='1.5'><model name='crate'><static>1</static><link name='x'>"
        + collision("1 1 1")
        + "</link></model></sdf>"
    )
    monkeypatch.setenv("GAZEBO_MODEL_PATH", f"/nowhere:{tmp_path / 'models'}")
    uri = "<uri>model://crate</uri>"
    world, found = world_of(
        tmp_path,
        f"<include>{uri}<pose>3 0 0 0 0 0</pose></include><include>{uri}<name>other</name>"
        "<pose>-3 0 0 0 0 0</pose></include><include><uri>https://example.org/models/Depot</uri>"
        "</include><include><uri>model://sun</uri></include><light name='l'/>",
    )
    assert distance(world, (0, 0, 0), (1, 0, 0)) == pytest.approx(2.5)
    assert distance(world, (0, 0, 0), (-1, 0, 0)) == pytest.approx(2.5)
    assert found.notices == [
        "the model https://example.org/models/Depot, which is not on this machine,"
    ]


def test_a_missing_ground_is_replaced_by_a_floor(tmp_path: Path) -> None:
    missing = "<include><uri>https://example.org/models/Depot</uri></include>"
    bot = "<model name='m'><link name='l'>" + collision("1 1 1") + "</link></model>"
    world, found = world_of(tmp_path, missing + bot)
    assert found.notices[-1] == "its ground, which a flat floor replaces,"
    assert distance(world, (3, 0, 2), (0, 0, -1)) == pytest.approx(2)
    _, found = world_of(tmp_path, missing + FLOOR)
    assert len(found.notices) == 1
    world, found = world_of(tmp_path, bot)
    assert not found.notices
    assert distance(world, (3, 0, 2), (0, 0, -1)) < 0


def test_a_scale_of_one_number_is_that_of_all_axes(tmp_path: Path) -> None:
    (tmp_path / "a.dae").write_text(COLLADA)
    mesh = "<geometry><mesh><uri>a.dae</uri><scale>2</scale></mesh></geometry>"
    content = f"<model name='r'><static>1</static><link name='x'><collision name='c'>{mesh}"
    world, _ = world_of(tmp_path, content + "</collision></link></model>")
    assert distance(world, (0.1, -0.1, 0), (0, 0, 1)) == pytest.approx(2.0, abs=0.02)


def test_tags_of_a_link_that_have_no_effect_are_named(tmp_path: Path) -> None:
    surface = (
        "<surface><friction><ode><mu>1</mu><mu2>0.1</mu2></ode></friction>"
        "<contact><ode><kp>1e6</kp></ode></contact></surface>"
    )
    box = collision("1 1 1").replace("</collision>", surface + "</collision>")
    link = f"<link name='l'><gravity>false</gravity>{box}</link>"
    _, found = world_of(tmp_path, f"<model name='m'>{link}</model>")
    assert found.notices == ["what <gravity>, <kp>, <mu2> say"]


@pytest.mark.parametrize(
    "address", ["model://../../etc/passwd", "package://../..", "file://../../etc/passwd"]
)
def test_an_address_does_not_leave_its_folder(address: str) -> None:
    assert find_resource(address) is None


def test_a_loop_of_includes_is_one_sentence(tmp_path: Path) -> None:
    (tmp_path / "b.sdf").write_text(
        "<sdf version='1.5'><model name='b'><include><uri>b.sdf</uri></include></model></sdf>"
    )
    with pytest.raises(ZbotError, match=r"b\.sdf includes itself"):
        world_of(tmp_path, "<include><uri>b.sdf</uri></include>")


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        ("<model name='m'><link name='l'><pose>nan 0 0 0 0 0</pose></link></model>", "6 numbers"),
        (
            (
                "<model name='m'><link name='a'><pose relative_to='b'/></link>"
                "<link name='b'><pose relative_to='a'/></link></model>"
            ),
            "relative to itself",
        ),
        ("<model name='m'><link name='a'/><link name='a'/></model>", "two links have the name"),
        ("<model name='m'><link name='a'><inertial><mass>-1</mass></inertial></link></model>", "0"),
    ],
)
def test_a_damaged_world_is_one_sentence(tmp_path: Path, content: str, reason: str) -> None:
    with pytest.raises(ZbotError, match=reason):
        world_of(tmp_path, content)


def test_what_never_moves_may_have_a_damaged_mass(tmp_path: Path) -> None:
    inertial = "<inertial><mass>nan</mass></inertial>"
    content = f"<model name='m'><static>true</static><link name='a'>{inertial}</link></model>"
    world_of(tmp_path, content)


WHEEL = """<link name='{0}'><pose>0 {1} 0.1 -1.5707963 0 0</pose><inertial><mass>0.2</mass><inertia>
<ixx>0.001</ixx><iyy>0.001</iyy><izz>0.001</izz></inertia></inertial><collision name='c'><geometry>
<cylinder><radius>0.1</radius><length>0.04</length></cylinder></geometry></collision></link>
<joint name='{0}_joint' type='revolute'><parent>base</parent><child>{0}</child><axis>
<xyz>0 0 1</xyz></axis></joint>"""
BASE = (
    """<link name='base'><pose>0 0 0.1 0 0 0</pose><inertial><mass>3</mass><inertia><ixx>0.05</ixx>
<iyy>0.05</iyy><izz>0.05</izz></inertia></inertial><collision name='c'>"""
    + BOX.format("0.3 0.2 0.1")
    + """</collision><sensor name='eye' type='gpu_lidar'><pose>0.1 0 0.2 0 0 0</pose>
<topic>scan</topic><lidar><scan><horizontal><samples>4</samples></horizontal></scan></lidar></sensor></link>
<link name='ball'><pose>-0.13 0 0.02 0 0 0</pose><inertial><mass>0.1</mass></inertial>
<collision name='c'><geometry><sphere><radius>0.02</radius></sphere></geometry></collision></link>
<joint name='ball_joint' type='ball'><parent>base</parent><child>ball</child></joint>"""
)
DRIVE = """<plugin filename='gz-sim-diff-drive-system' name='gz::sim::systems::DiffDrive'>
<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint>
<wheel_separation>0.3</wheel_separation><wheel_radius>0.1</wheel_radius></plugin>"""


def test_a_robot_in_sdf_drives_and_its_sensor_is_where_its_pose_says() -> None:
    wheels = WHEEL.format("left", 0.15) + WHEEL.format("right", -0.15)
    model, root = robot(BASE + wheels + DRIVE)
    world = World(Plan().spec())
    (body,) = world.add([("bot", model, root)], on_floor=False)
    assert body.link_pose(model.equipment.sensors[0].link).translation == pytest.approx(
        (0.1, 0, 0.3), abs=0.01
    )
    body.command = (0.3, 0.0, 0.0)
    for _ in range(500):
        world.step()
    assert body.pose.translation[0] == pytest.approx(0.58, abs=0.05)
    names, _, _ = body.joint_states()
    assert names == ["left_joint", "right_joint"]


def test_a_true_pose_is_that_of_the_model_and_not_that_of_its_root() -> None:
    pose = "<plugin name='gz::sim::systems::OdometryPublisher' filename='x'/>"
    model, root = robot(BASE + pose)
    (body,) = World(Plan().spec()).add([("bot", model, root)], on_floor=False)
    (truth,) = (sensor for sensor in model.equipment.sensors if isinstance(sensor, TruePose))
    assert body.link_pose(truth.link).translation == pytest.approx((0, 0, 0))


def test_the_frame_of_a_sensor_is_the_one_that_its_description_names() -> None:
    link = "<link name='l'><sensor name='s' type='{}'>{}</sensor></link>"
    for kind, tags, frame in (
        ("gpu_lidar", "<frame_id>scan</frame_id>", "scan"),
        ("camera", "<frame_id>a</frame_id><optical_frame_id>b</optical_frame_id>", "b"),
        ("camera", "<gz_frame_id>a</gz_frame_id><optical_frame_id>b</optical_frame_id>", "b"),
        ("imu", "", "bot/l/s"),
    ):
        model, _ = robot(link.format(kind, tags))
        assert model.equipment.sensors[0].frame == frame


def test_a_model_without_links_is_refused() -> None:
    with pytest.raises(DescriptionError, match="no <link>"):
        model_of("<sdf version='1.9'><model name='a'/></sdf>")


def test_limits_of_joints_are_radians_and_a_motor_holds_positions() -> None:
    arm = (
        "<robot name='arm'><link name='world'/><link name='base'/><joint name='fix' type='fixed'>"
        "<parent link='world'/><child link='base'/></joint><link name='rod'><inertial>"
        "<origin xyz='0.2 0 0'/><mass value='1'/><inertia ixx='0.01' iyy='0.01' izz='0.01'/>"
        "</inertial></link><joint name='hinge' type='revolute'><parent link='base'/>"
        "<child link='rod'/><origin xyz='0 0 1'/><axis xyz='0 1 0'/>"
        "<limit lower='-1' upper='1' effort='100' velocity='5'/></joint>"
        "<ros2_control name='s' type='system'><joint name='hinge'><command_interface "
        "name='position'/><state_interface name='position'/></joint></ros2_control><gazebo>"
        "<plugin filename='libgazebo_ros2_control.so' name='c'/></gazebo></robot>"
    )
    world = World(Plan().spec())
    (robot_,) = world.add([("arm", read_robot(arm, GazeboPlace("arm", "w")), Rigid())])
    for target, reached in ((-0.7, -0.7), (0.5, 0.5), (3.0, 1.0)):
        robot_.joint_motors.command("hinge", "position", target)
        for _ in range(250):
            world.step()
        assert robot_.joint_states()[1] == pytest.approx([reached], abs=0.05)


@pytest.mark.parametrize("name", ["a" * 5000, "a\0b", "\udc81" * 300])
@pytest.mark.parametrize("scheme", ["https://fuel.example.org/1.0/robots/models/", "model://", ""])
def test_an_address_that_can_be_no_file_name_is_not_found(scheme: str, name: str) -> None:
    assert find_resource(scheme + name) is None


@pytest.mark.parametrize("address", ["model://", "package://", "package:///a", "model://a%00b/c"])
def test_an_address_without_the_name_of_a_package_names_no_file(address: str) -> None:
    assert find_resource(address) is None
