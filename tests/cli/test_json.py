"""Test of the keys that commands print with `--json`, against the table in docs/json.md."""

from __future__ import annotations

import json
import re
import shlex
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

import zbot as library
from zbot.action import ActionServer
from zbot.lifecycle import LifecycleNode
from zbot.tf2 import StaticTransformBroadcaster
from zbot_cli.main import NOUNS
from zbot_cli.nouns import load, verbs

from example_interfaces.action import Fibonacci
from geometry_msgs.msg import PoseStamped, TransformStamped
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor
from std_msgs.msg import Header, String
from std_srvs.srv import Empty

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin, Start

ROOT = Path(__file__).parents[2]
ROWS = dict(
    re.findall(r"^\| `zbot (.+?)` \| (.+) \|$", (ROOT / "docs/json.md").read_text(), re.MULTILINE)
)
#: Commands whose rows other tests check, because they need a class, a robot or a call.
ELSEWHERE = (
    "bag info",
    "class start",
    "control",
    "class next",
    "security",
    "action echo",
    "service echo",
    "pkg deps",
)
#: Commands whose dictionaries belong to the classroom.
OWN_KEYS = {"class list", "class check"}
STREAMS = ("topic hz", "topic bw", "topic delay")


@pytest.fixture
def robot(make_context: MakeContext, spin: Spin) -> library.Node:
    """Return a node that has one of everything."""
    node = library.Node("robot", context=make_context())
    chatter = node.create_publisher(String, "chatter", 10)
    pose = node.create_publisher(PoseStamped, "pose", 10)
    node.create_subscription(String, "chatter", lambda _: None, 10)
    node.create_service(Empty, "reset", lambda _, response: response)
    node.create_client(Empty, "reset")
    limits = [FloatingPointRange(from_value=0.0, to_value=2.0, step=0.5)]
    text = ParameterDescriptor(
        description="in m/s", additional_constraints="none", floating_point_range=limits
    )
    node.declare_parameter("speed", 1.0, text)

    def compute(goal: Any) -> Any:
        goal.publish_feedback(Fibonacci.Feedback(sequence=[0]))
        goal.succeed()
        return Fibonacci.Result(sequence=[0, 1])

    frames = [
        TransformStamped(header=Header(frame_id=parent), child_frame_id=child)
        for parent, child in (("map", "odom"), ("base_link", "laser"))
    ]
    StaticTransformBroadcaster(node).sendTransform(frames)
    ActionServer(node, Fibonacci, "fibonacci", compute)

    def speak() -> None:
        chatter.publish(String(data="hello"))
        message = PoseStamped()
        message.header.stamp = node.get_clock().now().to_msg()
        pose.publish(message)

    node.create_timer(0.05, speak)
    spin(node, LifecycleNode("managed", context=node.context))
    return node


def keys(value: Any) -> set[str]:
    """Return the keys at all levels, without names, and without the fields of messages."""
    if isinstance(value, list):
        return set().union(*map(keys, value))
    if not isinstance(value, dict):
        return set()
    found = set()
    for key, inner in value.items():
        found |= {key} if re.match("[a-z_]*$", key) else set()
        found |= keys(inner)
    return found


@pytest.mark.parametrize("command", [row for row in ROWS if not row.startswith(ELSEWHERE)])
@pytest.mark.usefixtures("robot")
def test_each_command_prints_the_keys_that_the_page_says(command: str, start: Start) -> None:
    program = start("zbot", *shlex.split(command), "--json")
    if command.startswith(STREAMS):
        lines = [program.wait_for("{")]
    else:
        program.wait()
        lines = [line for line in program.lines if line.startswith(("{", "["))]
    printed = [json.loads(line) for line in lines]
    assert printed, program.output
    named = set(re.findall("`([a-z_]+)`", ROWS[command]))
    found = keys(printed)
    if "..." in ROWS[command]:  # the other keys are those of a message
        assert named <= found
    elif "<parameter>" in ROWS[command]:
        assert any(key.startswith("/") for key in printed[0])
    else:
        assert found == named


def test_every_command_with_json_is_on_the_page() -> None:
    documented = {" ".join(command.split()[:2]) for command in ROWS}
    for noun in set(NOUNS) - {"run"}:
        command = load(noun)
        for verb, child in (verbs(command) or {"": command}).items():
            words = f"{noun} {verb}".strip()
            has_json = any("--json" in option.opts for option in child.params)
            assert not has_json or words.replace("-", "_") in documented | OWN_KEYS, words
