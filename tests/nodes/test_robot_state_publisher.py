"""Tests of robot_state_publisher: its frames, topics and parameters."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot_nodes.description.robot_state_publisher import RobotStatePublisher, read_robot

from sensor_msgs.msg import JointState
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import Start
    from tests.nodes.conftest import Bench

KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
URDF = """<robot name="arm">
<link name="base"/><link name="turret"/><link name="finger"/><link name="thumb"/><link name="cam"/>
<joint name="turn" type="continuous"><parent link="base"/><child link="turret"/>
  <origin xyz="0 0 0.5"/><axis xyz="0 0 1"/></joint>
<joint name="slide" type="prismatic"><parent link="turret"/><child link="finger"/>
  <axis xyz="0 1 0"/><limit lower="0" upper="1" effort="1" velocity="1"/></joint>
<joint name="other" type="prismatic"><parent link="turret"/><child link="thumb"/>
  <axis xyz="0 1 0"/><limit lower="0" upper="1" effort="1" velocity="1"/>
  <mimic joint="slide" multiplier="-2" offset="0.1"/></joint>
<joint name="mount" type="fixed"><parent link="base"/><child link="cam"/>
  <origin xyz="0.1 0 0" rpy="0 0 3.141592653589793"/></joint>
</robot>"""


def state(bench: Bench, **positions: float) -> JointState:
    message = JointState(name=list(positions), position=list(positions.values()))
    message.header.stamp = bench.stamp()
    return message


def frames(messages: list[Any]) -> dict[str, Any]:
    return {
        transform.child_frame_id: transform
        for message in messages
        for transform in message.transforms
    }


SDF = """<sdf version="1.8"><model name="arm"><link name="base"/>
<link name="turret"><pose>0 0 0.5 0 0 0</pose></link>
<joint name="turn" type="revolute"><parent>base</parent><child>turret</child>
<axis><xyz>0 0 1</xyz></axis></joint></model></sdf>"""


def test_an_empty_description_is_named() -> None:
    with pytest.raises(DescriptionError, match="it is empty"):
        read_robot("  \n")


def test_a_description_in_sdf_has_frames_too(bench: Bench) -> None:
    pytest.importorskip("numpy")
    moving, described = (
        bench.watch(TFMessage, "/tf"),
        bench.watch(String, "/robot_description", KEPT),
    )
    bench.run(RobotStatePublisher, {"robot_description": SDF})
    assert wait_until(lambda: bool(described))
    bench.publisher(JointState, "/joint_states").publish(state(bench, turn=math.pi / 2))
    assert wait_until(lambda: bool(moving))
    turret = frames(moving)["turret"]
    assert turret.header.frame_id == "base"
    assert turret.transform.translation.z == pytest.approx(0.5)
    assert turret.transform.rotation.z == pytest.approx(math.sqrt(0.5))


def test_joints_become_frames(bench: Bench) -> None:
    moving, fixed = bench.watch(TFMessage, "/tf"), bench.watch(TFMessage, "/tf_static", KEPT)
    described = bench.watch(String, "/robot_description", KEPT)
    bench.run(RobotStatePublisher, {"robot_description": URDF})
    assert wait_until(lambda: bool(described) and bool(fixed))
    assert described[0].data == URDF
    mount = frames(fixed)["cam"]
    assert list(frames(fixed)) == ["cam"]
    assert mount.header.frame_id == "base"
    assert mount.transform.translation.x == 0.1
    assert mount.transform.rotation.z == pytest.approx(1)

    sent = state(bench, turn=1.0, slide=0.25, unknown=5.0)
    bench.publisher(JointState, "joint_states").publish(sent)
    assert wait_until(lambda: len(frames(moving)) == 3)
    turret, finger, thumb = (frames(moving)[frame] for frame in ("turret", "finger", "thumb"))
    assert turret.header.stamp == sent.header.stamp
    assert turret.header.frame_id == "base"
    assert turret.transform.translation.z == 0.5
    assert turret.transform.rotation.z == pytest.approx(math.sin(0.5))
    assert finger.transform.translation.y == 0.25
    assert thumb.transform.translation.y == pytest.approx(-0.4)  # -2 * 0.25 + 0.1


def test_a_prefix_is_put_before_every_frame(bench: Bench) -> None:
    fixed = bench.watch(TFMessage, "/tf_static", KEPT)
    bench.run(RobotStatePublisher, {"robot_description": URDF, "frame_prefix": "left/"})
    assert wait_until(lambda: bool(fixed))
    assert frames(fixed)["left/cam"].header.frame_id == "left/base"


def test_the_rate_is_limited_by_the_time_stamps(bench: Bench) -> None:
    moving = bench.watch(TFMessage, "/tf")
    node = bench.run(RobotStatePublisher, {"robot_description": URDF, "publish_frequency": 20.0})
    publisher = bench.publisher(JointState, "joint_states")
    first = state(bench, turn=1.0)
    publisher.publish(first)
    start = zbot.Time.from_msg(first.header.stamp)
    for after_ms, angle in ((49, 2.0), (50, 3.0)):
        message = state(bench, turn=angle)
        message.header.stamp = (start + zbot.Duration(nanoseconds=after_ms * 10**6)).to_msg()
        publisher.publish(message)
    assert wait_until(lambda: len(moving) == 2)
    assert frames(moving)["turret"].transform.rotation.z == pytest.approx(math.sin(1.5))

    node.set_parameters([zbot.Parameter("ignore_timestamp", value=True)])
    publisher.publish(JointState(name=["turn"], position=[0.5]))
    assert wait_until(lambda: len(moving) == 3)


def test_a_new_description_is_used_at_once(bench: Bench) -> None:
    described = bench.watch(String, "/robot_description", KEPT)
    fixed = bench.watch(TFMessage, "/tf_static", KEPT)
    node = bench.run(RobotStatePublisher, {"robot_description": URDF})
    moved = URDF.replace('xyz="0.1 0 0"', 'xyz="0.7 0 0"')
    results = node.set_parameters([zbot.Parameter("robot_description", value=moved)])
    assert results[0].successful
    assert wait_until(lambda: bool(described) and described[-1].data == moved)
    assert wait_until(lambda: bool(fixed) and frames(fixed)["cam"].transform.translation.x == 0.7)


@pytest.mark.parametrize(
    ("name", "value", "reason"),
    [
        ("robot_description", "", "Empty URDF is not allowed"),
        ("robot_description", "<robot/>", "a <robot> has no name"),
        ("publish_frequency", 1000.5, "publish_frequency must be between 0.0 and 1000.0"),
        ("publish_frequency", -1.0, "publish_frequency must be between 0.0 and 1000.0"),
    ],
)
def test_parameters_that_cannot_be_used_are_refused(
    bench: Bench, name: str, value: Any, reason: str
) -> None:
    node = bench.run(RobotStatePublisher, {"robot_description": URDF})
    result = node.set_parameters([zbot.Parameter(name, value=value)])[0]
    assert (result.successful, reason in result.reason) == (False, True)
    with pytest.raises(DescriptionError):
        bench.run(RobotStatePublisher, {"robot_description": URDF, name: value})


def test_the_defaults_are_those_of_the_genuine_node(bench: Bench) -> None:
    node = bench.run(RobotStatePublisher, {"robot_description": URDF})
    names = ("publish_frequency", "frame_prefix", "ignore_timestamp")
    assert [node.get_parameter(name).value for name in names] == [20.0, "", False]


def test_messages_that_fit_no_joint_are_ignored(bench: Bench, logged: list[Any]) -> None:
    moving = bench.watch(TFMessage, "/tf")
    bench.run(RobotStatePublisher, {"robot_description": URDF})
    publisher = bench.publisher(JointState, "joint_states")
    publisher.publish(JointState(name=["turn"]))
    publisher.publish(JointState(name=["turn"], position=[1.0, 2.0]))
    publisher.publish(JointState(name=["turn"], position=[1.0]))
    publisher.publish(state(bench, turn=1.0))
    assert wait_until(lambda: len(moving) == 1)
    text = "\n".join(record.message for record in logged)
    assert "whose position member was empty" in text
    assert "ignored an invalid JointState message" in text
    assert "joint_states without a time stamp are ignored" in text


def test_the_program_reads_a_file_and_says_what_is_wrong(start: Start, tmp_path: Path) -> None:
    path = tmp_path / "arm.urdf"
    path.write_text(URDF)
    words = ("zbot", "run", "robot_state_publisher", "robot_state_publisher")
    start(*words, str(path)).wait_for("Robot initialized")
    missing = start(*words, "none.urdf")
    missing.wait_for("error: the robot description is not valid: cannot read 'none.urdf'")
    assert missing.wait() == 1
    wrong = start(*words, "--ros-args", "-p", "robot_description:=5")
    wrong.wait_for("error: Trying to set parameter 'robot_description' to '5'")
    assert wrong.wait() == 1
