"""Tests of the simulated robot in real processes, through its topics."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.names import is_hidden
from zbot_nodes.robot.pose import pose_of
from zbot_nodes.robot.world import distance

from geometry_msgs.msg import PoseStamped, Twist  # isort: skip
from nav_msgs.msg import Odometry, Path  # isort: skip
from sensor_msgs.msg import CameraInfo, Image, Imu, JointState, LaserScan  # isort: skip
from tf2_msgs.msg import TFMessage  # isort: skip

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import MakeContext, Program, Spin, Start


class Student(zbot.Node):
    """Node that receives every topic of the robot and drives it."""

    TOPICS: tuple[tuple[type[Any], str], ...] = (
        (Odometry, "/odom"),
        (JointState, "/joint_states"),
        (LaserScan, "/scan"),
        (Imu, "/imu"),
        (Image, "/camera/image_raw"),
        (CameraInfo, "/camera/camera_info"),
        (TFMessage, "/tf"),
        (TFMessage, "/tf_static"),
        (Path, "/plan"),
    )

    def __init__(self, context: zbot.Context) -> None:
        super().__init__("student", context=context)
        self.heard: dict[str, Any] = {}
        for msg_type, topic in self.TOPICS:
            latched = zbot.DurabilityPolicy.TRANSIENT_LOCAL
            durability = latched if topic == "/tf_static" else zbot.DurabilityPolicy.VOLATILE
            qos = zbot.QoSProfile(depth=10, durability=durability)
            self.create_subscription(
                msg_type, topic, lambda msg, topic=topic: self.heard.update({topic: msg}), qos
            )
        self.command = Twist()
        self.drives = False
        self.wheel = self.create_publisher(Twist, "/cmd_vel", 10)
        self.goal = self.create_publisher(PoseStamped, "/goal_pose", 10)
        self.create_timer(0.1, self.drive)

    def drive(self) -> None:
        if self.drives:
            self.wheel.publish(self.command)

    def order(self, speed: float, turn: float) -> None:
        command = Twist()
        command.linear.x, command.angular.z = speed, turn
        self.command, self.drives = command, True

    def hears(self, *topics: str) -> bool:
        return wait_until(lambda: set(topics) <= set(self.heard), 15)

    @property
    def x(self) -> float:
        return pose_of(self.heard["/odom"]).x

    @property
    def speed(self) -> float:
        return float(self.heard["/odom"].twist.twist.linear.x)

    @property
    def turn(self) -> float:
        return float(self.heard["/odom"].twist.twist.angular.z)

    def aim(self, x: float, y: float) -> None:
        """Publish a goal when the navigation listens."""
        goal = PoseStamped()
        goal.pose.position.x, goal.pose.position.y = x, y
        assert wait_until(lambda: self.goal.get_subscription_count() > 0)
        self.goal.publish(goal)


@pytest.fixture
def student(make_context: MakeContext, spin: Spin) -> Student:
    student = Student(make_context())
    spin(student)
    return student


@pytest.fixture
def base(start: Start) -> Program:
    program = start("zbot", "run", "robot_base")
    program.wait_for("Base ready")
    return program


@pytest.mark.usefixtures("base")
def test_the_base_publishes_its_odometry(student: Student) -> None:
    assert student.hears("/odom", "/joint_states", "/tf", "/tf_static")
    odom = student.heard["/odom"]
    assert (odom.header.frame_id, odom.child_frame_id) == ("odom", "base_link")
    assert pose_of(odom) == pytest.approx((0.0, 0.0, 0.0), abs=1e-3)
    assert student.heard["/joint_states"].name == ["wheel_left_joint", "wheel_right_joint"]
    (moving,) = student.heard["/tf"].transforms
    assert (moving.header.frame_id, moving.child_frame_id) == ("odom", "base_link")
    mounts = {transform.child_frame_id for transform in student.heard["/tf_static"].transforms}
    assert mounts == {"laser", "imu_link", "camera_link", "camera_optical_frame"}


@pytest.mark.usefixtures("base")
def test_the_base_moves_when_commanded_and_stops_without_commands(student: Student) -> None:
    assert student.hears("/odom")
    student.order(0.5, 1.0)
    assert wait_until(lambda: student.x > 0.1 and student.speed == pytest.approx(0.5, abs=0.01))
    assert wait_until(lambda: student.turn == pytest.approx(1.0, abs=0.02))
    assert pose_of(student.heard["/odom"]).yaw > 0.1
    assert student.hears("/joint_states", "/tf")
    assert wait_until(
        lambda: list(student.heard["/joint_states"].velocity) == pytest.approx([7.0, 13.0], abs=0.2)
    )
    assert wait_until(lambda: student.heard["/tf"].transforms[0].transform.translation.x > 0)
    student.drives = False
    assert wait_until(lambda: abs(student.speed) < 0.01)


def test_the_base_stops_at_walls(student: Student, base: Program) -> None:
    assert student.hears("/odom")
    student.order(-9.0, 0.0)  # faster than its motors
    base.wait_for("Bump: something is in the way at (-1.", 10)
    assert wait_until(lambda: abs(student.speed) < 0.01 and -1.81 <= student.x < -1.77)
    student.order(0.5, 0.0)
    assert wait_until(lambda: student.x > -1.7, 10)


@pytest.mark.usefixtures("base")
def test_the_laser_shows_the_distance_to_the_walls(student: Student, start: Start) -> None:
    start("zbot", "run", "robot_laser").wait_for("Laser ready")
    assert student.hears("/scan", "/odom")
    scan = student.heard["/scan"]
    assert (scan.header.frame_id, len(scan.ranges)) == ("laser", 360)
    for ray, expected in ((0, 4.0), (90, 2.5), (180, 2.0), (270, 2.5)):
        assert scan.ranges[ray] == pytest.approx(expected, abs=0.1)
    student.order(0.5, 0.5)
    assert wait_until(lambda: student.x > 0.2, 10)
    student.order(0.0, 0.0)
    assert wait_until(lambda: student.speed == 0.0)

    def is_seen_from_here() -> bool:
        x, y, yaw = pose_of(student.heard["/odom"])
        return all(
            abs(seen - distance(x, y, yaw + math.radians(ray))) < 0.1
            for ray, seen in enumerate(student.heard["/scan"].ranges)
            if ray in {0, 30, 180, 300}
        )

    assert wait_until(is_seen_from_here, 10)


@pytest.mark.usefixtures("base")
def test_the_imu_feels_turning_and_gravity(student: Student, start: Start) -> None:
    start("zbot", "run", "robot_imu").wait_for("Inertial sensor ready")
    assert student.hears("/imu")
    still = student.heard["/imu"]
    assert still.header.frame_id == "imu_link"
    assert still.angular_velocity.z == pytest.approx(0, abs=0.05)
    assert still.linear_acceleration.z == pytest.approx(9.81, abs=0.3)
    student.order(0.0, 1.5)
    assert wait_until(lambda: abs(student.heard["/imu"].angular_velocity.z - 1.5) < 0.05, 10)
    assert wait_until(lambda: abs(student.heard["/imu"].orientation.z) > 0.2, 10)


@pytest.mark.usefixtures("base")
def test_the_camera_image_has_sky_wall_and_floor(student: Student, start: Start) -> None:
    start("zbot", "run", "robot_camera").wait_for("Camera ready")
    assert student.hears("/camera/image_raw", "/camera/camera_info")
    image = student.heard["/camera/image_raw"]
    assert (image.width, image.height, image.encoding, image.step) == (320, 240, "rgb8", 960)
    assert len(image.data) == 320 * 240 * 3

    def pixel(row: int, column: int = 160) -> tuple[int, ...]:
        start = row * image.step + 3 * column
        return tuple(image.data[start : start + 3])

    assert pixel(0) == (170, 210, 250)
    assert pixel(239) == (90, 90, 90)
    red, green, blue = pixel(120)
    assert red > green > blue
    # Four metres away, half of the wall is 277 * 0.3 / 4 = 20 pixels high.
    assert pixel(120 - 22) == pixel(0)
    assert pixel(120 - 18) == pixel(120) == pixel(120 + 18)
    info = student.heard["/camera/camera_info"]
    assert (info.width, info.height, info.k[0]) == (320, 240, 277.0)


@pytest.fixture
def navigation(start: Start, base: Program) -> Callable[..., Program]:
    del base  # drives
    start("zbot", "run", "robot_laser").wait_for("Laser ready")

    def run(*words: str) -> Program:
        program = start("zbot", "run", "robot_navigation", *words)
        program.wait_for("Navigation ready")
        return program

    return run


def test_navigation_drives_to_a_goal(student: Student, navigation: Callable[..., Program]) -> None:
    program = navigation()
    assert student.hears("/odom", "/scan")
    student.aim(0.4, 0.1)
    program.wait_for("New goal: (0.40, 0.10)")
    program.wait_for("Arrived at (0.")
    assert wait_until(lambda: math.dist(pose_of(student.heard["/odom"])[:2], (0.4, 0.1)) < 0.2)
    assert student.hears("/plan")
    points = [pose.pose.position for pose in student.heard["/plan"].poses]
    assert (points[-1].x, points[-1].y) == (0.4, 0.1)


def test_navigation_stops_before_an_obstacle(
    student: Student, navigation: Callable[..., Program]
) -> None:
    assert student.hears("/odom")
    student.order(1.0, 0.0)
    assert wait_until(lambda: student.x > 3.2, 15)
    student.drives = False
    program = navigation()
    assert student.hears("/scan")
    student.aim(9.0, 0.0)  # behind the wall
    program.wait_for("Obstacle ahead: giving up at (3.", 30)
    assert wait_until(lambda: abs(student.speed) < 0.01)
    assert 3.5 < student.x < 3.81


def test_navigation_patrols_until_another_node_drives(
    student: Student, navigation: Callable[..., Program]
) -> None:
    program = navigation("--ros-args", "-p", "patrol:=true")
    assert student.hears("/odom", "/plan")
    assert wait_until(lambda: student.x > 0.1, 20)
    student.order(0.0, -0.5)
    program.wait_for("Another node drives: pausing")
    turning = -0.5
    assert wait_until(lambda: student.turn == pytest.approx(turning, abs=0.02), 10)


def test_one_command_starts_the_whole_robot(student: Student, start: Start) -> None:
    robot = start("zbot", "launch", "zbot_nodes", "robot.launch.py", "patrol:=false")
    assert wait_until(
        lambda: (
            {"base_controller", "camera_driver", "imu", "laser_scanner", "navigation"}
            <= set(student.get_node_names())
        ),
        20,
    )
    every = [topic for _, topic in Student.TOPICS if topic != "/plan"]
    assert student.hears(*every)

    def driven() -> set[str]:
        return {info.node_name for info in student.get_subscriptions_info_by_topic("/cmd_vel")}

    assert wait_until(lambda: driven() == {"base_controller", "navigation"})
    # The topic between base and sensors is hidden.
    assert wait_until(
        lambda: (
            {topic for topic, _ in student.get_topic_names_and_types() if is_hidden(topic)}
            == {"/_ground_truth"}
        )
    )
    student.aim(0.2, 0.0)
    robot.wait_for("[navigation]: Arrived at (0.")
    assert robot.stop(timeout=15) == 0
    assert wait_until(lambda: "navigation" not in student.get_node_names(), 10)
