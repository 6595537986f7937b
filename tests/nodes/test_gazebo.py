"""Tests of the simulator as Gazebo: spawning, bridges, services, plugins and ros2_control."""

from __future__ import annotations

import json
import math
from typing import TYPE_CHECKING, Any

import pytest

pytest.importorskip("mujoco", reason="the simulator needs the extra `sim`")

from tests.nodes.conftest import arrives
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.simulation.node.pace import Pace
from zbot.simulation.node.simulator import Gazebo, Simulator
from zbot.simulation.world import World
from zbot.simulation.worlds.plan import Plan
from zbot_nodes.simulation.body_control import start_control
from zbot_nodes.simulation.gz import read_command
from zbot_nodes.simulation.parameter_bridge import Bridge

from gazebo_msgs.srv import SpawnEntity as ClassicSpawn  # isort: skip
from ros_gz_interfaces.srv import SpawnEntity  # isort: skip
from controller_manager_msgs.srv import ConfigureController, LoadController, SwitchController
from geometry_msgs.msg import Pose, Twist, TwistStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import JointState, LaserScan
from std_msgs.msg import Float64MultiArray
from tf2_msgs.msg import TFMessage

if TYPE_CHECKING:
    from pathlib import Path

    import zbot
    from tests.conftest import Start
    from tests.nodes.conftest import Bench

INERTIAL = (
    "<inertial><mass value='{0}'/><inertia ixx='0.01' ixy='0' ixz='0' iyy='0.01' iyz='0' "
    "izz='0.01'/></inertial>"
)
WHEEL = (
    "<link name='{0}_wheel'>" + INERTIAL.format(0.2) + "<collision><geometry>"
    "<cylinder radius='0.1' length='0.04'/></geometry></collision></link>"
    "<joint name='{0}_joint' type='continuous'><parent link='base'/><child link='{0}_wheel'/>"
    "<origin xyz='0 {1} 0' rpy='-1.5708 0 0'/><axis xyz='0 0 1'/></joint>"
)
BODY = (
    "<robot name='bot'><link name='base'>" + INERTIAL.format(3) + "<collision><geometry>"
    "<box size='0.3 0.2 0.1'/></geometry></collision></link>"
    + WHEEL.format("left", 0.15)
    + WHEEL.format("right", -0.15)
    + "<link name='eye'/><joint name='eye_joint' type='fixed'><parent link='base'/>"
    "<child link='eye'/><origin xyz='0 0 0.2'/></joint><link name='ball'>"
    + INERTIAL.format(0.1)
    + "<collision><geometry><sphere radius='0.03'/></geometry></collision></link>"
    "<joint name='ball_joint' type='fixed'><parent link='base'/><child link='ball'/>"
    "<origin xyz='-0.12 0 -0.07'/></joint><gazebo reference='ball'><mu1>0</mu1></gazebo>"
)
NEW = (
    BODY + "<gazebo><plugin filename='gz-sim-diff-drive-system' "
    "name='gz::sim::systems::DiffDrive'><left_joint>left_joint</left_joint>"
    "<right_joint>right_joint</right_joint><wheel_separation>0.3</wheel_separation>"
    "<wheel_radius>0.1</wheel_radius></plugin><plugin filename='gz-sim-joint-state-publisher-"
    "system' name='gz::sim::systems::JointStatePublisher'><topic>states</topic></plugin></gazebo>"
    "<gazebo reference='eye'><sensor name='lidar' type='gpu_lidar'><update_rate>20</update_rate>"
    "<lidar><scan><horizontal><samples>8</samples></horizontal></scan></lidar></sensor></gazebo>"
    "</robot>"
)
OLD = (
    BODY + "<gazebo><plugin filename='libgazebo_ros_diff_drive.so' name='drive'><ros>"
    "<namespace>/own</namespace><remapping>odom:=odometry</remapping></ros>"
    "<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint>"
    "<wheel_separation>0.3</wheel_separation><wheel_diameter>0.2</wheel_diameter>"
    "<publish_odom_tf>true</publish_odom_tf><publish_wheel_tf>true</publish_wheel_tf>"
    "<odometry_frame>o</odometry_frame><robot_base_frame>base</robot_base_frame></plugin></gazebo>"
    "<gazebo reference='eye'><sensor name='lidar' type='ray'><update_rate>20</update_rate>"
    "<ray><scan><horizontal><samples>8</samples></horizontal></scan></ray>"
    "<plugin filename='libgazebo_ros_ray_sensor.so' name='p'><ros><remapping>~/out:=scan"
    "</remapping></ros><output_type>sensor_msgs/LaserScan</output_type>"
    "<frame_name>eye</frame_name></plugin></sensor></gazebo></robot>"
)
CONTROLLED = (
    BODY + "<ros2_control name='sim' type='system'><hardware>"
    "<plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>"
    + "".join(
        f"<joint name='{side}_joint'><command_interface name='velocity'/>"
        "<state_interface name='position'/><state_interface name='velocity'/></joint>"
        for side in ("left", "right")
    )
    + "</ros2_control><gazebo><plugin filename='gz_ros2_control-system' "
    "name='gz_ros2_control::GazeboSimROS2ControlPlugin'><parameters>{0}</parameters></plugin>"
    "</gazebo></robot>"
)


def connect(bench: Bench, *rows: tuple[str, str, str, str]) -> zbot.Node:
    """Run a bridge with these connections."""
    words = [f"{gazebo}@{kind}{sign}gz.msgs.Any" for gazebo, _, kind, sign in rows]
    remaps = [word for gazebo, ros, _, _ in rows for word in ("-r", f"{gazebo}:={ros}")]
    return bench.run(lambda **options: Bridge(words, cli_args=["--ros-args", *remaps], **options))


def simulate(bench: Bench, *, is_classic: bool = False) -> Simulator:
    """Run a simulator with a floor."""
    found = bench.run(
        lambda **options: Simulator(
            World(Plan().spec()),
            Pace(1.0),
            has_world_frame=False,
            world_name="w",
            gazebo=Gazebo(is_classic, start_control),
            **options,
        )
    )
    assert isinstance(found, Simulator)
    return found


def spawn(bench: Bench, text: str, *, name: str = "bot") -> None:
    """Add a robot by the service of the new Gazebo."""
    request = SpawnEntity.Request()
    request.entity_factory.name, request.entity_factory.sdf = name, text
    request.entity_factory.pose = Pose()
    request.entity_factory.pose.position.z = 0.11
    assert bench.call(SpawnEntity, "/world/w/create", request).success


def test_a_bridge_gives_the_topics_of_the_new_gazebo_other_names(bench: Bench) -> None:
    simulate(bench)
    spawn(bench, NEW)
    scan = "/world/w/model/bot/link/base/sensor/lidar/scan"
    connect(
        bench,
        ("/model/bot/cmd_vel", "/cmd_vel", "geometry_msgs/msg/TwistStamped", "]"),
        ("/model/bot/odometry", "/odom", "nav_msgs/msg/Odometry", "["),
        ("/model/bot/tf", "/tf", "tf2_msgs/msg/TFMessage", "["),
        ("/states", "/joint_states", "sensor_msgs/msg/JointState", "@"),
        (scan, "/scan", "sensor_msgs/msg/LaserScan", "["),
    )
    odometry, scans = bench.watch(Odometry, "/odom"), bench.watch(LaserScan, "/scan")
    frames, states = bench.watch(TFMessage, "/tf"), bench.watch(JointState, "/joint_states")
    commands = bench.publisher(TwistStamped, "/cmd_vel")
    command = TwistStamped()
    command.twist.linear.x = 0.4
    commands.publish(command)
    # As in Gazebo, one command lasts.
    assert arrives(lambda: odometry and odometry[-1].pose.pose.position.x > 0.3)
    assert (odometry[-1].header.frame_id, odometry[-1].child_frame_id) == ("bot/odom", "bot/base")
    assert arrives(lambda: scans)
    assert scans[-1].header.frame_id == "bot/base/lidar"
    assert states[-1].name == ["left_joint", "right_joint"]
    assert {frame.child_frame_id for found in frames for frame in found.transforms} == {"bot/base"}
    topics = {name for name, _ in bench.watcher.get_topic_names_and_types()}
    assert not any(name.startswith(("/model", "/world")) for name in topics)


def test_the_pose_publisher_tells_where_the_links_are_in_their_model(bench: Bench) -> None:
    plugin = (
        "<gazebo><plugin filename='gz-sim-pose-publisher-system' "
        "name='gz::sim::systems::PosePublisher'><use_pose_vector_msg>1</use_pose_vector_msg>"
        "<publish_nested_model_pose>1</publish_nested_model_pose>"
        "<static_publisher>1</static_publisher></plugin></gazebo></robot>"
    )
    simulate(bench)
    spawn(bench, NEW.replace("</robot>", plugin))
    connect(
        bench,
        ("/model/bot/pose", "/tf", "tf2_msgs/msg/TFMessage", "["),
        ("/model/bot/pose_static", "/tf_static", "tf2_msgs/msg/TFMessage", "["),
    )
    kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    moving, fixed = bench.watch(TFMessage, "/tf"), bench.watch(TFMessage, "/tf_static", kept)
    # The simulator also publishes here; its own message has no frames.
    assert arrives(lambda: moving and any(message.transforms for message in fixed))
    pairs = [(pose.header.frame_id, pose.child_frame_id) for pose in moving[-1].transforms]
    assert pairs == [("bot", "bot/left_wheel"), ("bot", "bot/right_wheel"), ("w", "bot")]
    assert moving[-1].transforms[0].transform.translation.y == pytest.approx(0.15, abs=1e-3)
    fixed_poses = {pose.child_frame_id: pose for message in fixed for pose in message.transforms}
    assert fixed_poses.keys() == {"bot/base", "bot/eye", "bot/ball"}
    assert fixed_poses["bot/eye"].transform.translation.z == pytest.approx(0.2)


def test_the_connections_end_with_their_bridge(bench: Bench) -> None:
    simulate(bench)
    spawn(bench, NEW)
    bridge = connect(bench, ("/model/bot/odometry", "/odom", "nav_msgs/msg/Odometry", "["))
    assert arrives(lambda: bench.watcher.count_publishers("/odom"))
    bridge.destroy_node()
    assert arrives(lambda: not bench.watcher.count_publishers("/odom"))


def test_plugins_of_gazebo_classic_have_their_own_names(bench: Bench) -> None:
    simulate(bench, is_classic=True)
    request = ClassicSpawn.Request(name="bot", xml=OLD, robot_namespace="/fleet")
    request.initial_pose.position.x, request.initial_pose.position.z = 1.0, 0.11
    assert bench.call(ClassicSpawn, "/spawn_entity", request).success
    odometry = bench.watch(Odometry, "/fleet/own/odometry")
    scans, frames = bench.watch(LaserScan, "/fleet/scan"), bench.watch(TFMessage, "/tf")
    command = Twist()
    command.linear.x = 0.4
    bench.publisher(Twist, "/fleet/own/cmd_vel").publish(command)
    # The odometry of the plugin is the true pose, unless its description says otherwise.
    assert arrives(lambda: odometry and odometry[-1].pose.pose.position.x > 1.3)
    assert arrives(lambda: scans)
    assert scans[-1].header.frame_id == "eye"
    pairs = {
        (frame.header.frame_id, frame.child_frame_id)
        for found in frames
        for frame in found.transforms
    }
    assert pairs == {("o", "base"), ("base", "left_wheel"), ("base", "right_wheel")}


def test_a_robot_that_cannot_be_spawned_is_one_sentence(bench: Bench) -> None:
    simulate(bench, is_classic=True)
    request = ClassicSpawn.Request(name="bot", xml="<robot name='r'/>")
    answer = bench.call(ClassicSpawn, "/spawn_entity", request)
    assert not answer.success
    assert answer.status_message == "the robot description is not valid: it has no <link>"


def test_controllers_move_the_bodies(bench: Bench, tmp_path: Path) -> None:
    file = tmp_path / "control.yaml"
    file.write_text(
        "controller_manager:\n  ros__parameters:\n    update_rate: 50\n    wheels:\n"
        "      type: velocity_controllers/JointGroupVelocityController\n"
        "    states:\n      type: joint_state_broadcaster/JointStateBroadcaster\n"
        "wheels:\n  ros__parameters:\n    joints: [left_joint, right_joint]\n"
    )
    simulator = simulate(bench)
    spawn(bench, CONTROLLED.format(file))
    for name in ("wheels", "states"):
        for type_, service in ((LoadController, "load"), (ConfigureController, "configure")):
            request = type_.Request(name=name)
            assert bench.call(type_, f"/controller_manager/{service}_controller", request).ok
    switch = SwitchController.Request(activate_controllers=["wheels", "states"])
    switch.strictness = SwitchController.Request.STRICT
    assert bench.call(SwitchController, "/controller_manager/switch_controller", switch).ok
    states = bench.watch(JointState, "/joint_states")
    speeds = Float64MultiArray(data=[4.0, 4.0])
    bench.publisher(Float64MultiArray, "/wheels/commands").publish(speeds)
    robot = simulator.world.robots["bot"]
    assert arrives(lambda: robot.pose.translation[0] > 0.3)
    assert arrives(lambda: states[-1].position[0] > math.pi)


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("gz sim -r -s -v4 a.sdf", (False, "a.sdf", True, False)),
        ("ign gazebo -v 4 -r a.sdf", (False, "a.sdf", True, True)),
        ("gz sim -g -v2", (False, "empty", False, True)),
        ("gz sim a.sdf --force-version 8 --render-engine ogre", (False, "a.sdf", True, True)),
        ("gzserver --verbose a.world -s libgazebo_ros_factory.so", (True, "a.world", True, False)),
        ("gazebo --verbose -s lib.so -s lib2.so a.world", (True, "a.world", True, True)),
        ("gzserver -slibgazebo_ros_init.so a.world", (True, "a.world", True, False)),
        ("gzclient", (True, "empty", False, True)),
    ],
)
def test_command_lines_of_gazebo_are_read(line: str, expected: tuple[Any, ...]) -> None:
    program, *words = line.split()
    assert read_command(program, words)[:4] == expected


def test_other_commands_of_gazebo_are_named() -> None:
    with pytest.raises(SystemExit, match="zbot has no `gz service`: it has `gz sim`"):
        read_command("gz", ["service", "-s", "/world/w/create"])


WORLD = (
    "<sdf version='1.9'><world name='w'><include><uri>model://ground_plane</uri></include>"
    "<model name='wall'><static>true</static><pose>2 0 0.5 0 0 0</pose><link name='l'><collision "
    "name='c'><geometry><box><size>0.2 9 1</size></box></geometry></collision></link></model>"
    "</world></sdf>"
)
LAUNCH = """
from launch import LaunchDescription
from launch.actions import ExecuteProcess, IncludeLaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare
def generate_launch_description():
    return LaunchDescription([
        Node(package="robot_state_publisher", executable="robot_state_publisher",
             parameters=[{"robot_description": open("bot.urdf").read()}]),
        %s
    ])
"""
NEW_LAUNCH = (
    LAUNCH
    % """
        IncludeLaunchDescription(
            PathJoinSubstitution([FindPackageShare("ros_gz_sim"), "launch", "gz_sim.launch.py"]),
            launch_arguments={"gz_args": "-r -s a.world"}.items()),
        Node(package="ros_gz_sim", executable="create",
             arguments=["-topic", "robot_description", "-name", "bot", "-z", "0.2"]),
        Node(package="ros_gz_bridge", executable="parameter_bridge",
             parameters=[{"config_file": "bridge.yaml"}])
"""
)
OLD_LAUNCH = (
    LAUNCH
    % """
        ExecuteProcess(cmd=["gzserver", "--verbose", "-s", "libgazebo_ros_factory.so", "a.world"]),
        Node(package="gazebo_ros", executable="spawn_entity.py",
             arguments=["-topic", "robot_description", "-entity", "bot", "-z", "0.2"])
"""
)
BRIDGE = [
    {
        "ros_topic_name": "scan",
        "gz_topic_name": "/world/w/model/bot/link/base/sensor/lidar/scan",
        "ros_type_name": "sensor_msgs/msg/LaserScan",
        "gz_type_name": "gz.msgs.LaserScan",
        "direction": "GZ_TO_ROS",
    }
]


@pytest.mark.parametrize(("text", "robot"), [(NEW_LAUNCH, NEW), (OLD_LAUNCH, OLD)])
def test_a_launch_file_for_gazebo_runs_unmodified(
    start: Start, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str, robot: str
) -> None:
    for name, content in (
        ("a.world", WORLD),
        ("bot.urdf", robot),
        ("bridge.yaml", json.dumps(BRIDGE)),
        ("a.launch.py", text),
    ):
        (tmp_path / name).write_text(content)
    monkeypatch.setenv("ZBOT_LOG_DIR", str(tmp_path / "log"))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setenv("PATH", "/usr/bin:/bin")
    program = start("zbot", "launch", "a.launch.py")
    program.wait_for("process has finished cleanly", 60)  # the robot is there
    scan = start("zbot", "topic", "echo", "--once", "/scan")
    assert scan.wait(30) == 0
    assert "frame_id: " in scan.output
    assert program.stop() == 0
