"""Tests of what a command says about words that are no command, and about forgotten words."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest

import zbot as library

from std_msgs.msg import String

if TYPE_CHECKING:
    from tests.cli.conftest import Command, Write
    from tests.conftest import MakeContext


@pytest.fixture
def files(write: Write) -> None:
    write("robot", scripts="'drive = robot.drive:main'", **{"robot/drive.py": ""})
    for name in ("talker.py", "a.launch.py", "lesson/metadata.yaml"):
        Path(name).parent.mkdir(exist_ok=True)
        Path(name).touch()


@pytest.mark.parametrize(
    ("words", "advice"),
    [
        ("turtlesim", "type: zbot run turtlesim"),
        ("turtlesim.py", "type: zbot run turtlesim"),
        ("sensor --ros-args -p rate:=2.0", "type: zbot run sensor --ros-args -p rate:=2.0"),
        ("demo_nodes_py talker", "type: zbot run demo_nodes_py talker"),
        ("robot", "type: zbot run robot NODE"),
        ("robot drive", "type: zbot run robot drive"),
        ("talker.py", "type: zbot run talker.py"),
        ("python3 talker.py", "type: zbot run talker.py"),
        ("a.launch.py", "type: zbot launch a.launch.py"),
        ("lesson", "type: zbot bag info lesson"),
        ("list", "type: zbot topic list or zbot node list or zbot service list"),
        ("list topics", "type: zbot topic list"),
        ("pub /x", "type: zbot topic pub /x"),
        ("ecoh /x", "type: zbot topic echo /x"),
        ("subscribe /x", "type: zbot topic echo /x"),
        ("String", "type: zbot interface show std_msgs/msg/String"),
        ("std_msgs/String", "type: zbot interface show std_msgs/msg/String"),
        ("std_msgs", "type: zbot interface package std_msgs"),
        ("help", "type: zbot --help"),
        ("stop", "end a node with Ctrl-C"),
        ("topic /chatter", "type: zbot topic echo /chatter"),
        ("topic sub /chatter", "type: zbot topic echo /chatter"),
        ("topic see /chatter", "type: zbot topic echo /chatter"),
        ("topic /x std_msgs/msg/Int8 1", "type: zbot topic pub /x std_msgs/msg/Int8 1"),
        ("node turtlesim", "type: zbot node info turtlesim"),
        ("node echo /x", "type: zbot topic echo /x"),
        ("topic call /x", "type: zbot service call /x"),
        ("param turtlesim background_r", "type: zbot param get turtlesim background_r"),
    ],
)
@pytest.mark.usefixtures("files")
def test_a_word_that_is_no_command_says_what_to_type(
    zbot_command: Command, words: str, advice: str
) -> None:
    refused = zbot_command(*words.split())
    assert (refused.code, refused.out) == (2, "")
    assert "No such command" in refused.err
    assert f"\nhint: {advice}" in refused.err


@pytest.mark.parametrize("words", ["nodes", "topics list", "topic lst", "action send x"])
def test_a_misspelt_command_is_suggested_alone(zbot_command: Command, words: str) -> None:
    refused = zbot_command(*words.split())
    assert "Did you mean '" in refused.err
    assert "hint: " not in refused.err


@pytest.mark.usefixtures("domain")
@pytest.mark.parametrize("words", ["frobnicate", "security frobnicate"])
def test_a_word_without_meaning_gets_no_advice(zbot_command: Command, words: str) -> None:
    refused = zbot_command(*words.split())
    assert (refused.code, refused.out) == (2, "")
    assert "No such command 'frobnicate'." in refused.err
    assert "hint: " not in refused.err


@pytest.mark.parametrize(
    ("name", "advice"),
    [("news", "zbot topic echo /news"), ("/ann", "zbot node info /ann")],
)
def test_a_running_name_is_no_command(
    zbot_command: Command, make_context: MakeContext, name: str, advice: str
) -> None:
    node = library.Node("ann", context=make_context())
    node.create_publisher(String, "news", 10)
    assert f"hint: type: {advice}\n" in zbot_command(name).err


@pytest.mark.parametrize(
    ("words", "advice"),
    [
        ("run topic list", "type: zbot topic list"),
        ("run zbot topic list", "type: zbot topic list"),
        ("run launch a.launch.py", "type: zbot launch a.launch.py"),
        ("run turtlesim.py", "type: zbot run turtlesim"),
        ("launch sensor", "type: zbot run sensor"),
        ("launch turtlesim.py", "type: zbot run turtlesim"),
        ("launch turtlesim", "multisim.launch.py; to run its node, type: zbot run turtlesim"),
        ("launch topic list", "type: zbot topic list"),
    ],
)
@pytest.mark.usefixtures("files")
def test_run_and_launch_name_the_command_that_was_meant(
    zbot_command: Command, words: str, advice: str
) -> None:
    refused = zbot_command(*words.split())
    assert (refused.code, refused.out) == (1, "")
    assert f"{advice}\n" in refused.err


@pytest.mark.parametrize(
    ("words", "advice"),
    [
        ("interface show", "for example: zbot interface show geometry_msgs/msg/Twist"),
        ("lifecycle set x", "for example: zbot lifecycle set /lc_talker configure"),
        ("launch", "for example: zbot launch my_package my_launch.py robot:=left"),
        ("bag convert", "for example: zbot bag convert -i lesson -o outputs.yaml"),
        ("bag record", "for example: zbot bag record --topics /chatter"),
        ("pkg create", "e.g. zbot pkg create my_package"),
        ("class start Session 11", "put words that belong together in quotes; for example: zbot"),
        ("node list 17", "write the domain of a student with a slash: /17"),
        ("topic temperature echo", "type: zbot topic echo temperature"),
        ("class status", "type: zbot class list, or for this machine: zbot status"),
    ],
)
def test_a_forgotten_word_is_shown_in_an_example(
    zbot_command: Command, words: str, advice: str
) -> None:
    refused = zbot_command(*words.split())
    assert refused.code != 0
    assert advice in refused.err


@pytest.mark.parametrize(
    "words",
    [
        ("topic", "pub", "std_msgs/msg/String", "data: x"),
        ("topic", "echo", "std_msgs/msg/String"),
        ("service", "call", "std_srvs/srv/Empty"),
        ("action", "send_goal", "example_interfaces/action/Fibonacci"),
    ],
)
def test_a_type_is_not_taken_for_a_forgotten_name(
    zbot_command: Command, words: tuple[str, ...]
) -> None:
    refused = zbot_command(*words)
    assert (refused.code, refused.out) == (1, "")
    assert f"{words[2]} is a type, not a name\n\nhint: write the name before it" in refused.err
