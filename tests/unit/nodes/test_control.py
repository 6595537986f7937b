"""Tests of the simulated hardware, of limits of speeds, and of trajectories."""

from __future__ import annotations

import math
import time
from typing import Any

import pytest

from tests.conftest import allowed
from zbot.libraries.robot_description.urdf import Mimic
from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot_nodes.control.diff_drive_controller import SpeedLimiter
from zbot_nodes.control.hardware import SimulatedHardware, read_components
from zbot_nodes.control.trajectory import Point, Trajectory, problem, read_points

from builtin_interfaces.msg import Duration
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint


def robot(control: str) -> str:
    return f'<robot name="r"><link name="base"/>{control}</robot>'


def control(inside: str, plugin: str = "mock_components/GenericSystem", params: str = "") -> str:
    hardware = f"<hardware><plugin>{plugin}</plugin>{params}</hardware>"
    return f'<ros2_control name="hw" type="system">{hardware}{inside}</ros2_control>'


WHEEL = """<joint name="w"><command_interface name="velocity"/><state_interface name="position">
<param name="initial_value">0.5</param></state_interface><state_interface name="velocity"/>
</joint>"""


def hardware(inside: str, **options: str) -> SimulatedHardware:
    return SimulatedHardware(read_components(robot(control(inside, **options))), {})


def test_interfaces_are_read_with_their_initial_values() -> None:
    (component,) = read_components(
        robot(control(WHEEL + '<gpio name="io"><state_interface name="x"/></gpio>'))
    )
    assert (component.name, component.kind, component.is_mock) == ("hw", "system", True)
    assert component.commands == ("w/velocity",)
    assert component.states == {"w/position": 0.5, "w/velocity": 0.0, "io/x": 0.0}
    assert read_components(robot("")) == []


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ('<ros2_control type="system"/>', "a <ros2_control> has no name"),
        ('<ros2_control name="a" type="motor"/>', "has the type 'motor', not system"),
        ('<ros2_control name="a" type="system"/>', "has no <hardware><plugin>"),
        (control("") + control(""), "two <ros2_control> tags have the name 'hw'"),
        (control("<joint/>"), "a <joint> of 'hw' has no name"),
        (control('<joint name="a"><command_interface/></joint>'), "a <command_interface> of 'a'"),
        (control(WHEEL.replace("0.5", "x")), "initial_value of 'w' must be a number, not 'x'"),
    ],
)
def test_an_invalid_control_tag_is_refused(text: str, reason: str) -> None:
    with pytest.raises(DescriptionError) as caught:
        read_components(robot(text))
    assert reason in str(caught.value)


def test_a_mock_only_mirrors_commands() -> None:
    found = hardware(WHEEL)
    found.read(0.1)
    assert found.states == {"w/position": 0.5, "w/velocity": 0.0}  # no command yet
    found.commands["w/velocity"] = 2.0
    found.read(0.1)
    assert found.states == {"w/position": 0.5, "w/velocity": 2.0}


@pytest.mark.parametrize(
    "options",
    [
        {"params": '<param name="calculate_dynamics">true</param>'},
        {"plugin": "gz_ros2_control/GazeboSimSystem"},
    ],
)
def test_dynamics_turn_wheels(options: dict[str, str]) -> None:
    found = hardware(WHEEL, **options)
    found.commands["w/velocity"] = 2.0
    found.read(0.1)
    found.read(0.1)
    assert found.states["w/position"] == pytest.approx(0.9)
    assert found.states["w/velocity"] == 2.0


def test_dynamics_measure_the_speed_of_positions_and_follow_accelerations() -> None:
    params = '<param name="calculate_dynamics">true</param>'
    joint = """<joint name="a"><command_interface name="{}"/><state_interface name="position"/>
    <state_interface name="velocity"/>
</joint>"""
    found = hardware(joint.format("position"), params=params)
    found.commands["a/position"] = 1.0
    found.read(0.5)
    assert found.states == {"a/position": 1.0, "a/velocity": 2.0}
    found = hardware(joint.format("acceleration"), params=params)
    found.commands["a/acceleration"] = 1.0
    found.read(0.5)
    assert found.states == {"a/position": 0.25, "a/velocity": 0.5}


def test_offsets_outputs_and_mimics() -> None:
    inside = """<joint name="a"><command_interface name="position"/>
    <state_interface name="position"/></joint>
    <joint name="b"><state_interface name="position"/></joint>
    <gpio name="io"><command_interface name="light"/><state_interface name="light"/></gpio>"""
    params = '<param name="position_state_following_offset">0.25</param>'
    components = read_components(robot(control(inside, params=params)))
    found = SimulatedHardware(components, {"b": Mimic("a", -2.0, 1.0)})
    found.commands |= {"a/position": 1.0, "io/light": 1.0}
    found.read(0.1)
    assert found.states == {"a/position": 1.25, "b/position": -1.5, "io/light": 1.0}


def test_disabled_commands_do_nothing() -> None:
    found = hardware(WHEEL, params='<param name="disable_commands">true</param>')
    found.commands["w/velocity"] = 2.0
    found.read(0.1)
    assert found.states["w/velocity"] == 0.0


# -- limits --------------------------------------------------------------------------------------


def run(limiter: SpeedLimiter, speed: float, steps: int, start: float = 0.0) -> list[float]:
    earlier, before, found = start, start, []
    for _ in range(steps):
        earlier, before = before, limiter.limited(speed, before, earlier, 0.1)
        found.append(round(before, 6))
    return found


def test_without_limits_a_speed_is_taken_at_once() -> None:
    assert run(SpeedLimiter(), 5.0, 1) == [5.0]


def test_speeds_accelerations_and_decelerations_are_limited() -> None:
    limiter = SpeedLimiter(max_velocity=1.0, max_acceleration=2.0, max_deceleration=-5.0)
    assert run(limiter, 9.0, 6) == [0.2, 0.4, 0.6, 0.8, 1.0, 1.0]
    assert run(limiter, -9.0, 4, 1.0) == [0.5, 0.0, -0.2, -0.4]
    assert run(limiter, -9.0, 7)[-1] == -1.0
    assert run(SpeedLimiter(min_velocity=-0.5, max_velocity=1.0), -9.0, 1) == [-0.5]


def test_braking_in_reverse_has_its_own_limit() -> None:
    limiter = SpeedLimiter(max_acceleration=1.0, max_acceleration_reverse=-2.0)
    assert run(limiter, -9.0, 2) == [-0.2, -0.4]
    other = SpeedLimiter(max_acceleration=1.0, max_deceleration_reverse=4.0)
    assert run(other, 9.0, 3, -0.8) == [-0.4, 0.0, 0.1]


def test_jerk_is_limited() -> None:
    assert run(SpeedLimiter(max_jerk=10.0), 1.0, 3) == [0.1, 0.3, 0.6]


# -- trajectories --------------------------------------------------------------------------------


def test_positions_are_joined_by_lines() -> None:
    found = Trajectory(Point(0, (0.0,)), [Point(1, (2.0,)), Point(3, (0.0,))])
    assert found.end_s == 3
    sampled = [found.sample(time) for time in (0, 0.5, 1.0, 2.0, 9.0)]
    assert [point.positions[0] for point in sampled] == [0, 1, 2, 1, 0]
    assert [point.velocities for point in sampled] == [(2,), (2,), (2,), (-1,), (0,)]
    assert found.sample(0.5, is_smooth=False).positions == (0.0,)


def test_speeds_give_a_cubic_curve() -> None:
    found = Trajectory(Point(0, (0.0,), (0.0,)), [Point(2, (1.0,), (0.0,))])
    middle = found.sample(1.0)
    assert middle.positions == pytest.approx((0.5,))
    assert middle.velocities == pytest.approx((0.75,))
    assert found.sample(0.5).positions == pytest.approx((0.15625,))


def test_accelerations_give_a_curve_of_degree_five() -> None:
    start = Point(0, (0.0,), (0.0,), (0.0,))
    found = Trajectory(start, [Point(1, (1.0,), (0.0,), (0.0,))])
    for share in (0.25, 0.5, 0.9):
        expected = 10 * share**3 - 15 * share**4 + 6 * share**5
        assert found.sample(share).positions == pytest.approx((expected,))
    assert found.sample(0.5).velocities == pytest.approx((1.875,))
    assert math.isclose(found.sample(0.5).accelerations[0], 0.0, abs_tol=1e-9)  # type: ignore[index]


def trajectory(
    *points: tuple[float, list[float]], names: str = "a b", **more: Any
) -> JointTrajectory:
    message = JointTrajectory(joint_names=names.split())
    for time_s, positions in points:
        after = Duration(sec=int(time_s), nanosec=int(time_s % 1 * 1e9))
        message.points.append(
            JointTrajectoryPoint(positions=positions, time_from_start=after, **more)
        )
    return message


@pytest.mark.parametrize(
    ("message", "reason"),
    [
        (trajectory(names=""), "Empty joint names"),
        (trajectory((1, [1.0]), names="c"), "do not match the controller's joints ['a', 'b']"),
        (trajectory((1, [1.0, 1.0]), names="a a"), "do not match"),
        (trajectory((1, [1.0]), names="a"), "Joints are missing"),
        (trajectory(), "Empty trajectory"),
        (trajectory((1, [1.0, 1.0]), (1, [1.0, 1.0])), "between points 0 and 1 is not strictly"),
        (trajectory((1, [])), "Point 0 has no positions"),
        (trajectory((1, [1.0])), "Point 0 has 1 positions, but there are 2 joints"),
        (trajectory((1, [1.0, 1.0]), velocities=[1.0, 0.0]), "last trajectory point is not zero"),
        (trajectory((1, [1.0, math.nan])), "positions that are not finite: nan for joint 'b'"),
        (
            trajectory((1, [1.0, 1.0]), accelerations=[-math.inf, 0.0]),
            "Point 0 has accelerations that are not finite: -inf for joint 'a'",
        ),
        (trajectory((1, [1.0, 1.0])), ""),
    ],
)
def test_messages_that_are_no_trajectory_are_refused(message: JointTrajectory, reason: str) -> None:
    found = problem(message, ("a", "b"), may_be_partial=False, may_move=False)
    assert (reason in found) if reason else found == ""


def test_joints_of_a_message_are_put_into_order() -> None:
    message = trajectory((1.5, [1.0, 2.0]), names="b a", velocities=[0.1, 0.2])
    (point,) = read_points(message, ("a", "b", "c"), (7.0, 8.0, 9.0))
    assert point == Point(1.5, (2.0, 1.0, 9.0), (0.2, 0.1, 0.0))


def test_thousands_of_control_tags_are_read_quickly() -> None:
    hardware = "<hardware><plugin>a</plugin></hardware>"
    tags = (
        f'<ros2_control name="{n}" type="system">{hardware}</ros2_control>' for n in range(10_000)
    )
    begin = time.process_time()
    assert len(read_components(robot("".join(tags)))) == 10_000
    assert time.process_time() - begin < allowed(2)
