"""Tests of the nodes that publish goals for controllers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

from tests.conftest import wait_until
from zbot_nodes.control.forward_position_publisher import ForwardPositionPublisher
from zbot_nodes.control.joint_trajectory_publisher import JointTrajectoryPublisher
from zbot_nodes.startup.program import ParameterError

from sensor_msgs.msg import JointState
from std_msgs.msg import Float64MultiArray
from trajectory_msgs.msg import JointTrajectory

if TYPE_CHECKING:
    from tests.nodes.conftest import Bench

FAST: dict[str, Any] = {"wait_sec_between_publish": 0.05}
JOINTS = {**FAST, "joints": ["a", "b"], "goal_names": ["one"]}


def test_positions_are_published_in_turn(bench: Bench) -> None:
    found = bench.watch(Float64MultiArray, "/commands")
    goals = {"goal_names": ["up", "down"], "up": [1.0, 2.0], "down": [0, 0]}
    bench.run(ForwardPositionPublisher, {**FAST, **goals, "publish_topic": "/commands"})
    assert wait_until(lambda: len(found) >= 3)
    values = [list(message.data) for message in found[:3]]
    assert values in ([[1, 2], [0, 0], [1, 2]], [[0, 0], [1, 2], [0, 0]])


def test_trajectories_go_to_the_controller(bench: Bench) -> None:
    found = bench.watch(JointTrajectory, "/arm/joint_trajectory")
    goal = {"one.positions": [1.0, 2.0], "one.velocities": [0.5, 0.5]}
    bench.run(JointTrajectoryPublisher, {**JOINTS, **goal, "controller_name": "arm"})
    assert wait_until(lambda: bool(found))
    (point,) = found[0].points
    assert list(found[0].joint_names) == ["a", "b"]
    assert (list(point.positions), list(point.velocities)) == ([1.0, 2.0], [0.5, 0.5])
    assert point.time_from_start.sec == 4


def test_trajectories_wait_for_a_start_between_the_limits(bench: Bench, logged: list[Any]) -> None:
    found = bench.watch(JointTrajectory, "/position_trajectory_controller/joint_trajectory")
    settings = {"check_starting_point": True, "starting_point_limits.a": [0.0, 1.0]}
    parameters = {**JOINTS, "one.positions": [1.0, 2.0], **settings}
    outside = bench.run(JointTrajectoryPublisher, parameters)
    assert wait_until(lambda: any("no joint_states came" in record.message for record in logged))
    states = bench.publisher(JointState, "/joint_states")
    states.publish(JointState(name=["a", "b"], position=[2.0, 0.0]))
    assert wait_until(lambda: any("outside their limits: a" in record.message for record in logged))
    assert not found
    outside.destroy_node()
    bench.run(JointTrajectoryPublisher, parameters)

    def arrives() -> bool:
        states.publish(JointState(name=["a", "b"], position=[0.5, 0.0]))
        return bool(found)

    assert wait_until(arrives)


@pytest.mark.parametrize(
    ("make", "parameters", "reason"),
    [
        (ForwardPositionPublisher, {}, "pos1 is empty"),
        (ForwardPositionPublisher, {"pos1": "up"}, "pos1 must be a list of numbers"),
        (ForwardPositionPublisher, {"wait_sec_between_publish": 0}, "must be above 0"),
        (ForwardPositionPublisher, {"goal_names": []}, "goal_names is empty"),
        (JointTrajectoryPublisher, {}, "joints is empty"),
        (JointTrajectoryPublisher, JOINTS, "one.positions is empty"),
        (JointTrajectoryPublisher, {**JOINTS, "one.positions": [1.0]}, "must have 2 numbers"),
    ],
)
def test_wrong_parameters_are_named(
    bench: Bench, make: Any, parameters: dict[str, Any], reason: str
) -> None:
    with pytest.raises(ParameterError, match=reason):
        bench.run(make, parameters)
