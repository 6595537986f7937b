"""Test of a robot as robots are written: one launch, a gamepad that drives it, and its frames."""

from __future__ import annotations

import math
import shutil
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.tf2 import Buffer, TransformException, TransformListener

from geometry_msgs.msg import TwistStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import JointState, Joy
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

if TYPE_CHECKING:
    from tests.conftest import Program, Start
    from tests.nodes.conftest import Bench

ROVER = Path(__file__).parents[1] / "programs" / "rover"
LEFT_OUT = {
    "rplidar_ros": "a compiled driver of a laser scanner",
    "stage_ros2": "a simulator in C++",
}
Matrix = list[list[float]]


@pytest.fixture
def rover(start: Start, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Program:
    """Launch the robot with one command, and wait until its controllers are active."""
    pytest.importorskip("xacro", reason="an extra: pip install 'zbot[robot]'")
    shutil.copytree(ROVER / "src", tmp_path / "src")
    monkeypatch.setenv("PATH", "/usr/bin:/bin")  # no environment is active
    monkeypatch.setenv("ZBOT_LOG_DIR", str(tmp_path / "log"))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    program = start("zbot", "launch", "rover_bringup", "rover.launch.py")
    program.wait_for("Configured and activated arm_controller", 60)
    return program


# -- forward kinematics, written without zbot's own ----------------------------------------------


def moved(x: float, y: float, z: float) -> Matrix:
    return [[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z], [0, 0, 0, 1]]


def turned(axis: str, angle: float) -> Matrix:
    c, s = math.cos(angle), math.sin(angle)
    rows: dict[str, Matrix] = {
        "x": [[1, 0, 0], [0, c, -s], [0, s, c]],
        "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
        "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]],
    }
    return [*([*row, 0.0] for row in rows[axis]), [0, 0, 0, 1]]


def chained(*matrices: Matrix) -> Matrix:
    product = moved(0, 0, 0)
    for grid in matrices:
        product = [
            [sum(product[i][k] * grid[k][j] for k in range(4)) for j in range(4)] for i in range(4)
        ]
    return product


def as_matrix(transform: Any) -> Matrix:
    t, q = transform.transform.translation, transform.transform.rotation
    x, y, z, w = q.x, q.y, q.z, q.w
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), t.x],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), t.y],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), t.z],
        [0, 0, 0, 1],
    ]


def expected_frames(
    joints: dict[str, float], pose: tuple[float, float, float]
) -> dict[str, Matrix]:
    """Return where every link is in `odom`, from the numbers in the description."""
    x, y, heading = pose
    base = chained(moved(x, y, 0), turned("z", heading), moved(0, 0, 0.08))
    arm = chained(
        base, moved(0.1, 0, 0.05), turned("y", -math.pi / 6), turned("z", joints["shoulder"])
    )
    grip = joints["gripper"]
    frames = {
        "base_link": base,
        "laser": chained(base, moved(0.2, 0, 0.1), turned("z", math.pi)),
        "arm": arm,
        "left_finger": chained(arm, moved(0.3, grip, 0)),
        "right_finger": chained(arm, moved(0.3, -grip, 0)),
    }
    for side, across in (("left", 0.2), ("right", -0.2)):
        angle = joints[f"{side}_wheel_joint"]
        wheel = chained(moved(0, across, 0), turned("x", -math.pi / 2), turned("z", angle))
        frames[f"{side}_wheel"] = chained(base, wheel)
    return frames


def pose_of(odometry: Odometry) -> tuple[float, float, float]:
    place, turn = odometry.pose.pose.position, odometry.pose.pose.orientation
    return place.x, place.y, 2 * math.atan2(turn.z, turn.w)


# -- the robot -----------------------------------------------------------------------------------


def test_a_robot_is_launched_driven_and_its_frames_are_right(bench: Bench, rover: Program) -> None:
    for name, what in LEFT_OUT.items():
        assert rover.output.count(f"{name} is left out: it is {what}") == 1
    assert "rover_hardware/RoverMotors is a compiled driver" in rover.output

    odometry = bench.watch(Odometry, "/base_controller/odom")
    states = bench.watch(JointState, "/joint_states")
    buffer = Buffer()
    listener = TransformListener(buffer, bench.watcher, spin_thread=False)
    joy = bench.publisher(Joy, "/joy")
    joy.publish(Joy(axes=[0.0, 1.0], buttons=[0] * 8))  # the enable button is not pressed
    pressed = Joy(axes=[0.4, 1.0], buttons=[0, 0, 0, 0, 1, 0, 0, 0])

    def drives() -> bool:
        joy.publish(pressed)
        return bool(odometry) and pose_of(odometry[-1])[0] > 0.4

    assert wait_until(drives, 30)
    assert max(message.twist.twist.linear.x for message in odometry) == pytest.approx(0.5, rel=0.05)
    joy.publish(Joy(axes=[0.4, 1.0], buttons=[0] * 8))
    assert wait_until(lambda: bool(odometry) and odometry[-1].twist.twist.linear.x == 0, 30)

    nav = bench.publisher(TwistStamped, "/nav_vel")
    nav.publish(TwistStamped())  # the source of the lower priority is connected too
    point = JointTrajectoryPoint(positions=[-0.75, 0.04])
    point.time_from_start.sec = 1
    arm = bench.publisher(JointTrajectory, "/arm_controller/joint_trajectory")
    arm.publish(JointTrajectory(joint_names=["shoulder", "gripper"], points=[point]))

    def joints() -> dict[str, float]:
        return dict(zip(states[-1].name, states[-1].position, strict=True)) if states else {}

    assert wait_until(lambda: joints().get("shoulder") == pytest.approx(-0.75), 30)
    assert joints()["gripper"] == pytest.approx(0.04)

    def differences() -> dict[str, float]:
        found = {}
        for link, matrix in expected_frames(joints(), pose_of(odometry[-1])).items():
            try:
                seen = as_matrix(buffer.lookup_transform("odom", link, zbot.Time()))
            except TransformException:
                return {link: math.inf}
            pairs = zip(chain(*seen), chain(*matrix), strict=True)
            found[link] = max(abs(a - b) for a, b in pairs)
        return found

    # The robot stands still, so all frames become those of the last joint states.
    assert wait_until(lambda: max(differences().values()) < 1e-6, 30), differences()
    x, y, heading = pose_of(odometry[-1])
    left, right = (0.08 * joints()[f"{side}_wheel_joint"] for side in ("left", "right"))
    assert heading == pytest.approx((right - left) / 0.4, abs=1e-6)
    assert 0.4 < math.hypot(x, y) <= (left + right) / 2 + 1e-6  # a chord and its arc
    assert heading > 0.1
    assert y > 0
    assert rover.process.poll() is None
    assert rover.stop(timeout=20) == 0
    assert listener is not None


def test_strict_refuses_the_robot(
    start: Start, tmp_path: Path, rover_words: tuple[str, ...]
) -> None:
    shutil.copytree(ROVER / "src", tmp_path / "src")
    program = start(*rover_words, "--strict")
    assert program.wait(30) == 1
    assert "does not run here" in program.output


@pytest.fixture
def rover_words(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> tuple[str, ...]:
    pytest.importorskip("xacro", reason="an extra: pip install 'zbot[robot]'")
    monkeypatch.setenv("ZBOT_LOG_DIR", str(tmp_path / "log"))
    return ("zbot", "launch", "rover_bringup", "rover.launch.py")
