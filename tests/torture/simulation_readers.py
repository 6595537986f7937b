"""Readers of the simulator: robots, surfaces and worlds of other programs."""

from __future__ import annotations

import struct
from importlib.util import find_spec

import zbot  # noqa: F401 - makes the messages importable
from tests.torture.reader import Reader, file_with, text_of
from zbot.classroom.errors import ClassValueError
from zbot.libraries.robot_description.inertia import read_inertia
from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot.simulation.errors import SimulationError
from zbot.simulation.gazebo.equipment import read_equipment, urdf_tags
from zbot.simulation.gazebo.names import PlainNames
from zbot.simulation.marking.grammar import parse_task
from zbot.simulation.meshes.file import read_points, read_triangles
from zbot.simulation.meshes.pieces import convex_pieces
from zbot.simulation.node.ports import read_connections
from zbot.simulation.robots.catalog import find_robot
from zbot.simulation.robots.model import GazeboPlace, read_robot
from zbot.simulation.sdf.resources import find_resource
from zbot.simulation.sdf.robot import robot_of
from zbot.simulation.sdf.world import sdf_world
from zbot.simulation.world import World
from zbot.simulation.worlds.mjcf import mjcf_spec
from zbot.simulation.worlds.plan import Plan
from zbot.tf2.rigid import Rigid
from zbot_nodes.simulation.parameter_bridge import read_file
from zbot_nodes.startup.program import ParameterError

_WHEEL = (
    "<link name='{0}'><inertial><mass value='0.1'/><inertia ixx='1e-4' iyy='1e-4' izz='1e-4'/>"
    "</inertial><collision><geometry><cylinder radius='0.05' length='0.02'/></geometry></collision>"
    "</link><joint name='{0}_joint' type='continuous'><parent link='a'/><child link='{0}'/>"
    "<origin xyz='0 {1} 0'/><axis xyz='0 1 0'/></joint>"
)
_ROBOT = (
    "<robot name='r'><link name='a'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1'/>"
    "</inertial></link>"
    + _WHEEL.format("left_wheel", 0.1)
    + _WHEEL.format("right_wheel", -0.1)
    + "<gazebo reference='a'><mu1>0.2</mu1><sensor type='ray'><update_rate>5</update_rate><ray>"
    "<scan><horizontal><samples>8</samples><min_angle>-1</min_angle><max_angle>1</max_angle>"
    "</horizontal></scan><range><min>0.1</min><max>9</max></range></ray></sensor></gazebo>"
    "<gazebo><plugin filename='libgazebo_ros_diff_drive.so'><left_joint>left_wheel_joint"
    "</left_joint><right_joint>right_wheel_joint</right_joint><wheel_radius>0.05</wheel_radius>"
    "</plugin></gazebo></robot>"
).encode()
_VALUE_SENSORS = (
    b"<robot name='r'><gazebo reference='a'><sensor type='sonar'><sonar><min>0.1</min><max>2</max>"
    b"<radius>0.5</radius></sonar></sensor><sensor type='gps'><origin><latitude>50</latitude>"
    b"</origin></sensor><sensor type='battery'><battery><capacity>5</capacity></battery></sensor>"
    b"<sensor type='lidar'><lidar><scan><vertical><samples>4</samples></vertical></scan></lidar>"
    b"</sensor></gazebo></robot>"
)
_MESH = bytes(80) + struct.pack("<I12fH", 1, *range(12), 0)
_WORLD = (
    b"<mujoco><worldbody><geom type='plane' size='5 5 1'/><body name='b' pos='1 0 1'><freejoint/>"
    b"<geom size='0.1'/></body></worldbody></mujoco>"
)
_MANY = (
    b"<mujoco><size nuserdata='4'/><asset><hfield name='h' nrow='4' ncol='4' size='1 1 1 1'/>"
    b"<texture name='t' type='2d' builtin='flat' width='4' height='4'/></asset><worldbody>"
    b"<geom type='hfield' hfield='h'/></worldbody></mujoco>"
)


def _simulated(data: bytes) -> None:
    """Drive a robot for a moment."""
    world = World(Plan().spec())
    (robot,) = world.add([("r", read_robot(text_of(data)), Rigid())])
    robot.command = (0.1, 0.0, 0.1)
    for _ in range(3):
        world.step()


_SDF = (
    b"<sdf version='1.9'><world name='w'><include><uri>model://ground_plane</uri></include>"
    b"<model name='m'><static>1</static><frame name='f'><pose>1 0 0 0 0 0</pose></frame>"
    b"<link name='l'><pose relative_to='f'>0 0 1 0 0 0</pose><collision name='c'><geometry><box>"
    b"<size>1 1 1</size></box></geometry></collision></link></model><model name='b'><link name='a'>"
    b"<inertial><mass>1</mass></inertial><sensor name='s' type='gpu_lidar'><pose>1 0 0 0 0 0</pose>"
    b"<topic>scan</topic></sensor></link><link name='c'><visual name='v'><geometry><sphere><radius>"
    b"0.1</radius></sphere></geometry></visual></link><joint name='j' type='revolute'><parent>a"
    b"</parent><child>c</child><pose>0 0 1 0 0 0</pose><axis><xyz>0 0 1</xyz></axis></joint>"
    b"<plugin filename='f' name='gz::sim::systems::JointStatePublisher'/></model></world></sdf>"
)
_HILLS = (
    b"<sdf version='1.9'><world name='w'><spherical_coordinates><latitude_deg>1</latitude_deg>"
    b"</spherical_coordinates><model name='m'><static>1</static><link name='l'><collision name='c'>"
    b"<geometry><heightmap><uri>../hills/hills.pgm</uri><size>9 9 2</size><pos>0 0 1</pos>"
    b"</heightmap></geometry></collision></link></model></world></sdf>"
)
_COLLADA = (
    b"<COLLADA><asset><unit meter='1'/><up_axis>Z_UP</up_axis></asset><library_geometries>"
    b"<geometry id='g'><mesh><source id='p'><float_array>0 0 0 1 0 0 0 1 0 0 0 1</float_array>"
    b"</source><vertices id='v'><input semantic='POSITION' source='#p'/></vertices><triangles>"
    b"<input semantic='VERTEX' source='#v' offset='0'/><p>0 1 2 0 1 3</p></triangles></mesh>"
    b"</geometry></library_geometries><library_visual_scenes><visual_scene><node><matrix>"
    b"1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix><instance_geometry url='#g'/></node></visual_scene>"
    b"</library_visual_scenes></COLLADA>"
)


def _sdf_world(data: bytes) -> None:
    """Read a world in SDF, and move it for a moment."""
    file_with("hills.pgm", b"P5 3 3 255\n" + bytes(range(9)))
    found = sdf_world(file_with("world.sdf", data))
    world = World(found.spec)
    robots = [
        (entity.name, robot_of(entity.model, GazeboPlace(entity.name, found.name))[0], entity.pose)
        for entity in found.entities
    ]
    world.add(robots, on_floor=False)
    for _ in range(3):
        world.step()


_WITHOUT_EXTRA = (
    Reader(
        "robot_inertia",
        ("zbot.libraries.robot_description.inertia",),
        lambda data: read_inertia(text_of(data)),
        (DescriptionError,),
        (_ROBOT,),
    ),
    Reader(
        "gazebo_tags",
        (
            "zbot.simulation.gazebo.equipment",
            "zbot.simulation.gazebo.sensors",
            "zbot.simulation.gazebo.plugins",
            "zbot.simulation.robots.value_sensors",
        ),
        lambda data: read_equipment(urdf_tags(text_of(data)), PlainNames(), ""),
        (DescriptionError,),
        (_ROBOT, _VALUE_SENSORS),
    ),
    Reader(
        "marking_goals",
        ("zbot.simulation.marking.grammar",),
        lambda data: parse_task(text_of(data), {"exit": (1.0, 2.0)}),
        (ClassValueError,),
        (
            b"reaches (3, -2.5) within 60 s and touches nothing",
            b"visits exit, (1, 2) and exit within 20 s; follows the wall for 5 m",
            b"stops within 0.3 m of an obstacle and runs /solver",
        ),
    ),
    Reader(
        "collada_mesh",
        ("zbot.simulation.meshes.collada",),
        lambda data: convex_pieces(read_triangles(file_with("mesh.dae", data)).astype(float)[:200]),
        (SimulationError,),
        (_COLLADA,),
    ),
    Reader(
        "sdf_address",
        ("zbot.simulation.sdf.resources",),
        lambda data: find_resource(text_of(data)),
        (),
        (b"model://crate/model.sdf", b"file:///tmp/a", b"package://a/b", b"https://a.org/1/b/c/d"),
    ),
    Reader(
        "gazebo_bridge",
        ("zbot_nodes.simulation.parameter_bridge",),
        lambda data: read_file(str(file_with("bridge.yaml", data))),
        (ParameterError,),
        (
            (
                b"- {ros_topic_name: s, gz_topic_name: /s, ros_type_name: sensor_msgs/msg/Image,"
                b" direction: GZ_TO_ROS}\n- {topic_name: odom}\n"
            ),
        ),
    ),
    Reader(
        "gazebo_connections",
        ("zbot.simulation.node.ports",),
        lambda data: read_connections(text_of(data)),
        (SimulationError,),
        (b'[["/scan", "/scan", "sensor_msgs/msg/LaserScan", "to_ros"]]',),
    ),
    Reader(
        "robot_mesh",
        ("zbot.simulation.meshes.file",),
        lambda data: read_points(file_with("robot.stl", data)),
        (SimulationError,),
        (_MESH, b"solid a\nvertex 1 2 3\n", b"v 1 2 3\nv 1 2\n"),
    ),
)
_WITH_EXTRA = (
    Reader(
        "sdf_world",
        (
            *("zbot.simulation.sdf.world", "zbot.simulation.sdf.model"),
            *("zbot.simulation.sdf.document", "zbot.simulation.sdf.frames"),
            "zbot.simulation.sdf.heightmap",
        ),
        _sdf_world,
        (SimulationError, DescriptionError),
        (_SDF, _HILLS),
        2.0,
    ),
    Reader(
        "simulated_robot",
        ("zbot.simulation.robots.model", "zbot.simulation.robots.catalog"),
        _simulated,
        (DescriptionError, SimulationError),
        (_ROBOT,),
        2.0,
    ),
    Reader(
        "robot_file",
        ("zbot.simulation.robots.catalog",),
        lambda data: find_robot(str(file_with("robot.urdf", data.replace(b"<xacro:", b"<")))),
        (DescriptionError, SimulationError),
        (_ROBOT,),
    ),
    Reader(
        "mjcf_world",
        ("zbot.simulation.worlds.mjcf", "zbot.simulation.worlds.mjcf_limits"),
        lambda data: World(mjcf_spec(file_with("world.xml", data))),
        (SimulationError,),
        (_WORLD, _MANY),
        2.0,
    ),
)
SIMULATION_READERS = (*_WITHOUT_EXTRA, *(_WITH_EXTRA if find_spec("mujoco") else ()))
