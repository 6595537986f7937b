"""Tests of the values that joint_state_publisher gives to joints."""

from __future__ import annotations

import math

import pytest

from zbot.libraries.robot_description.urdf import Mimic, read_urdf
from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot_nodes.description.joint_values import Defaults, JointValue, JointValues

from sensor_msgs.msg import JointState


def joint(name: str, type_: str, inside: str = "", limits: str = "-1 2") -> str:
    lower, upper = limits.split()
    limit = f'<limit lower="{lower}" upper="{upper}" effort="1" velocity="1"/>'
    ends = f'<parent link="base"/><child link="{name}"/>'
    return f'<link name="{name}"/><joint name="{name}" type="{type_}">{ends}{limit}{inside}</joint>'


def values(
    joints: str,
    defaults: Defaults | None = None,
    zeros: dict[str, float] | None = None,
    dependent: dict[str, Mimic] | None = None,
) -> JointValues:
    robot = read_urdf(f'<robot name="r"><link name="base"/>{joints}</robot>')
    return JointValues(robot, defaults or Defaults(), zeros or {}, dependent or {})


def filled(joints: JointValues) -> JointState:
    message = JointState()
    joints.fill(message)
    return message


def test_zero_is_between_the_limits() -> None:
    three = (
        joint("a", "revolute") + joint("b", "prismatic", limits="1 2") + joint("c", "continuous")
    )
    found = values(three + joint("d", "fixed") + joint("e", "floating"), zeros={"a": 0.5})
    message = filled(found)
    assert message.name == ["a", "b", "c"]
    assert list(message.position) == [0.5, 1.5, 0.0]
    assert (list(message.velocity), list(message.effort)) == ([], [])
    assert (found.free["c"].lower, found.free["c"].upper) == (-math.pi, math.pi)


def test_soft_limits_are_used_on_request() -> None:
    soft = '<safety_controller soft_lower_limit="0.5" soft_upper_limit="9" k_velocity="1"/>'
    robot_joint = joint("a", "revolute", soft)
    assert (values(robot_joint).free["a"].lower, values(robot_joint).free["a"].upper) == (0.5, 2)
    assert values(robot_joint, Defaults(use_soft_limits=False)).free["a"].lower == -1


def test_defaults_choose_which_values_exist() -> None:
    robot_joint = joint("a", "revolute")
    message = filled(values(robot_joint, Defaults(positions=False, velocities=True, efforts=True)))
    assert list(message.position) == []
    assert (list(message.velocity), list(message.effort)) == ([0.0], [0.0])


def test_joints_follow_other_joints() -> None:
    mimic = '<mimic joint="a" multiplier="2" offset="1"/>'
    three = joint("a", "revolute") + joint("b", "revolute", mimic) + joint("c", "revolute")
    rules = {"c": Mimic("b", -1.0, 0.5)}
    found = values(three, Defaults(velocities=True), {"a": 0.25}, rules)
    found.take(JointState(name=["a", "b", "x"], position=[0.5, 9.0, 9.0], velocity=[3.0]))
    message = filled(found)
    assert list(message.position) == [0.5, 2.0, -1.5]
    assert list(message.velocity) == [3.0, 6.0, -6.0]
    assert list(values(three, Defaults(use_mimic=False)).free) == ["a", "b", "c"]


@pytest.mark.parametrize(
    ("rules", "reason"),
    [
        ({"a": Mimic("b"), "b": Mimic("a")}, "joint 'a' mimics itself through other joints"),
        ({"a": Mimic("x")}, "joint 'a' mimics 'x', which does not move"),
    ],
)
def test_rules_without_a_free_joint_are_refused(rules: dict[str, Mimic], reason: str) -> None:
    with pytest.raises(DescriptionError, match=reason):
        values(joint("a", "revolute") + joint("b", "revolute"), dependent=rules)


def test_joints_move_back_and_forth_between_their_limits() -> None:
    value = JointValue(-0.5, 1.0, 0.0, position=0.75)
    seen = []
    for _ in range(6):
        value.advance(0.5)
        seen.append(value.position)
    assert seen == [1.0, 0.5, 0.0, -0.5, -0.5, 0.0]
    turning = JointValue(-1.0, 1.0, 0.0, is_continuous=True, position=0.75)
    turning.advance(0.5)
    assert (turning.position, turning.forward) == (-1.0, True)
