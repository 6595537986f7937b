"""Tests of joint_state_publisher and of its sliders."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot_nodes.description.joint_state_publisher import JointStatePublisher
from zbot_nodes.description.joint_state_publisher_gui import JointStatePublisherGui

from sensor_msgs.msg import JointState
from std_msgs.msg import String
from std_srvs.srv import Empty

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import Start
    from tests.nodes.conftest import Bench

KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
URDF = """<robot name="r"><link name="base"/><link name="arm"/><link name="hand"/>
<joint name="turn" type="revolute"><parent link="base"/><child link="arm"/>
  <limit lower="-1" upper="2" effort="1" velocity="1"/></joint>
<joint name="grip" type="revolute"><parent link="arm"/><child link="hand"/>
  <limit lower="-1" upper="2" effort="1" velocity="1"/></joint></robot>"""


def describe(bench: Bench, text: str = URDF) -> None:
    bench.publisher(String, "/robot_description", KEPT).publish(String(data=text))


def positions(messages: list[Any]) -> list[float]:
    return list(messages[-1].position) if messages else []


def test_the_defaults_are_those_of_the_genuine_node(bench: Bench) -> None:
    node = bench.run(JointStatePublisher)
    expected = {
        "rate": 10,
        "publish_default_positions": True,
        "publish_default_velocities": False,
        "publish_default_efforts": False,
        "use_mimic_tags": True,
        "use_smallest_joint_limits": True,
        "source_list": [],
        "delta": 0.0,
    }
    assert {name: node.get_parameter(name).value for name in expected} == expected
    assert node.get_fully_qualified_name() == "/joint_state_publisher"


def test_the_description_comes_from_the_topic(bench: Bench) -> None:
    states = bench.watch(JointState, "/joint_states")
    bench.run(JointStatePublisher, {"rate": 50, "zeros.turn": 0.5})
    describe(bench)
    assert wait_until(lambda: positions(states) == [0.5, 0.0])
    assert states[-1].name == ["turn", "grip"]
    assert states[-1].header.stamp.sec > 0
    describe(bench, URDF.replace('name="turn"', 'name="swing"'))
    assert wait_until(lambda: bool(states) and states[-1].name[0] == "swing")


def test_sources_and_rules_of_parameters(bench: Bench) -> None:
    states = bench.watch(JointState, "/joint_states")
    rules = {"dependent_joints.grip.parent": "turn", "dependent_joints.grip.factor": 2.0}
    bench.run(JointStatePublisher, {"rate": 50, "source_list": ["arm/states"], **rules})
    describe(bench)
    source = bench.publisher(JointState, "/arm/states")
    assert wait_until(lambda: bool(states))
    source.publish(JointState(name=["turn"], position=[0.25]))
    assert wait_until(lambda: positions(states) == [0.25, 0.5])


def test_delta_moves_the_joints(bench: Bench) -> None:
    states = bench.watch(JointState, "/joint_states")
    bench.run(JointStatePublisher, {"rate": 50, "delta": 0.5})
    describe(bench)
    assert wait_until(lambda: len({tuple(state.position) for state in states}) > 3)


@pytest.mark.parametrize(
    ("parameters", "reason"),
    [
        ({"rate": 0}, "the parameter rate must be above 0"),
        ({"dependent_joints.a.speed": 1.0}, "must end with .parent, .factor or .offset"),
        ({"dependent_joints.a.factor": 1.0}, "dependent_joints.a.parent is missing"),
    ],
)
def test_parameters_that_cannot_be_used_are_refused(
    bench: Bench, tmp_path: Path, parameters: dict[str, Any], reason: str
) -> None:
    path = tmp_path / "r.urdf"
    path.write_text(URDF)
    overrides = [zbot.Parameter(name, value=parameter) for name, parameter in parameters.items()]
    with pytest.raises(DescriptionError, match=reason):
        JointStatePublisher(str(path), context=bench.context, parameter_overrides=overrides)


def test_a_description_that_cannot_be_used_is_a_warning(bench: Bench, logged: list[Any]) -> None:
    bench.run(JointStatePublisher)
    describe(bench, "<robot/>")
    assert wait_until(lambda: any("a <robot> has no name" in record.message for record in logged))


def test_sliders_are_parameters_with_the_limits_of_the_joints(bench: Bench) -> None:
    states = bench.watch(JointState, "/joint_states")
    node = bench.run(JointStatePublisherGui, {"rate": 50})
    describe(bench)
    assert wait_until(lambda: node.has_parameter("joints.grip"))
    (limits,) = node.describe_parameter("joints.turn").floating_point_range
    assert (limits.from_value, limits.to_value) == (-1, 2)
    node.set_parameters([zbot.Parameter("joints.turn", value=1.5)])
    assert wait_until(lambda: positions(states) == [1.5, 0.0])
    bench.call(Empty, "/joint_state_publisher/center", Empty.Request())
    assert wait_until(lambda: positions(states) == [0.0, 0.0])
    bench.call(Empty, "/joint_state_publisher/randomize", Empty.Request())
    assert wait_until(lambda: positions(states)[0] != 0.0)
    describe(bench, URDF.replace('name="turn"', 'name="swing"'))
    assert wait_until(lambda: node.has_parameter("joints.swing"))
    assert not node.has_parameter("joints.turn")


def test_the_program_reads_a_file(start: Start, tmp_path: Path) -> None:
    (tmp_path / "r.urdf").write_text(URDF)
    for package in ("joint_state_publisher", "joint_state_publisher_gui"):
        program = start("zbot", "run", package, package, "r.urdf")
        echo = start("zbot", "topic", "echo", "--once", "/joint_states")
        echo.wait_for("- turn")
        assert program.stop() == -2
    missing = start("zbot", "run", "joint_state_publisher", "joint_state_publisher", "none.urdf")
    missing.wait_for("cannot read 'none.urdf'")
    assert missing.wait() == 1
