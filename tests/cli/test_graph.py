"""Tests of `zbot graph` with running nodes."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree as ET

import pytest

import zbot as library
from tests.conftest import wait_until
from zbot.action import ActionClient, ActionServer

from example_interfaces.action import Fibonacci
from std_msgs.msg import Int32, String

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from tests.cli.conftest import Command
    from tests.conftest import MakeContext


def ignore(_: Any) -> None:
    """Receive a message and do nothing."""


def talk(context: library.Context) -> None:
    library.Node("talker", context=context).create_publisher(String, "chatter", 1)
    library.Node("listener", context=context).create_subscription(String, "chatter", ignore, 1)


def test_the_graph_is_printed_as_text(make_context: MakeContext, zbot_command: Command) -> None:
    talk(make_context())
    assert zbot_command("graph").out == "/talker -> [/chatter] -> /listener\n"
    assert zbot_command("graph", "--show", "nodes").out == (
        "/listener\n/talker\n/talker -> /listener  (/chatter)\n"
    )


def test_the_graph_is_printed_as_json(make_context: MakeContext, zbot_command: Command) -> None:
    talk(make_context())
    found = json.loads(zbot_command("graph", "--json").out)
    assert found["nodes"] == ["/listener", "/talker"]
    assert [topic["name"] for topic in found["topics"]] == ["/chatter"]
    assert {"from": "/talker", "to": "/chatter", "topic": None} in found["edges"]


def test_probable_mistakes_are_printed(make_context: MakeContext, zbot_command: Command) -> None:
    context = make_context()
    talk(context)
    node = library.Node("lost", context=context)
    node.create_subscription(String, "chater", ignore, 1)
    node.create_subscription(Int32, "chatter", ignore, 1)
    text = zbot_command("graph").out
    assert "nobody publishes /chater; did you mean '/chatter'?" in text
    assert (
        "two types on one topic exchange no messages:"
        " std_msgs/msg/Int32 (/lost), std_msgs/msg/String (/listener, /talker)" in text
    )
    assert "two types" in zbot_command("graph", "--show", "nodes").out


def test_filters_are_those_of_rqt_graph(make_context: MakeContext, zbot_command: Command) -> None:
    context = make_context()
    talk(context)
    library.Node("camera", namespace="robot", context=context).create_publisher(String, "image", 1)
    assert "/robot/camera" not in zbot_command("graph", "--nodes", "-/robot.*").out
    assert zbot_command("graph", "--topics", "/chatter").out.count("[/") == 1
    assert "[/robot/image]" not in zbot_command("graph", "--no-dead-sinks").out
    assert "[/rosout]" in zbot_command("graph", "--debug-topics").out


@pytest.mark.usefixtures("domain")
def test_an_invalid_filter_is_refused_with_a_sentence(zbot_command: Command) -> None:
    result = zbot_command("graph", "--nodes", "/robot(")
    assert (result.code, result.out) == (1, "")
    assert "invalid filter '/robot('" in result.err


def test_an_action_is_one_box(make_context: MakeContext, zbot_command: Command) -> None:
    context = make_context()
    server = library.Node("server", context=context)
    client = library.Node("client", context=context)
    ActionServer(server, Fibonacci, "count", ignore)
    ActionClient(client, Fibonacci, "count")
    assert zbot_command("graph").out == "/client <-> [/count action] <-> /server\n"
    assert "/client <-> /server  (/count)" in zbot_command("graph", "--show", "nodes").out
    assert "[/count/_action/feedback]" in zbot_command("graph", "--no-group-actions").out


def test_the_graph_is_printed_as_dot(make_context: MakeContext, zbot_command: Command) -> None:
    talk(make_context())
    text = zbot_command("graph", "--dot").out
    assert text.startswith("digraph graph_of_nodes {")
    assert '"n:/talker" -> "t:/chatter";' in text


def test_svg_goes_to_a_file_or_to_the_terminal(
    make_context: MakeContext, zbot_command: Command, tmp_path: Path
) -> None:
    talk(make_context())
    target = tmp_path / "graph.svg"
    result = zbot_command("graph", "--svg", str(target))
    assert (result.code, result.out, result.err) == (0, "", f"wrote {target}\n")
    text = target.read_text(encoding="utf-8")
    names = [element.get("data-node") for element in ET.fromstring(text).iter()]
    assert [name for name in names if name] == ["/listener", "/talker"]
    assert zbot_command("graph", "--svg", "-").out == text
    assert [path.name for path in tmp_path.iterdir()] == ["graph.svg"]


@pytest.mark.usefixtures("domain")
def test_an_unwritable_svg_file_is_one_sentence(zbot_command: Command, tmp_path: Path) -> None:
    result = zbot_command("graph", "--svg", str(tmp_path / "nowhere" / "graph.svg"))
    assert result.code == 1
    assert "cannot write" in result.err


@pytest.mark.usefixtures("domain")
def test_an_empty_graph_is_reported(zbot_command: Command) -> None:
    result = zbot_command("graph")
    assert (result.code, result.out) == (0, "no node is running\n")


def test_watch_updates_the_picture(
    make_context: MakeContext, start: Callable[..., Any], tmp_path: Path
) -> None:
    context = make_context()
    talk(context)
    target = tmp_path / "graph.svg"
    watching = start("zbot", "graph", "--watch", "--svg", str(target))
    watching.wait_for("wrote")
    library.Node("late", context=context).create_publisher(String, "news", 1)
    assert wait_until(lambda: "/late" in target.read_text(encoding="utf-8"))
    watching.stop()


def test_watch_prints_each_change(make_context: MakeContext, start: Callable[..., Any]) -> None:
    context = make_context()
    talk(context)
    watching = start("zbot", "graph", "--watch")
    watching.wait_for("/talker -> [/chatter] -> /listener")
    library.Node("late", context=context).create_publisher(String, "news", 1)
    watching.wait_for("/late -> [/news] -> (nobody)")
    watching.stop()
