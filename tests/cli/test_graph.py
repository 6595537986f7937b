"""`zbot graph` beside running nodes."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import zbot as library

from std_msgs.msg import Int32, String

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.cli.conftest import Command

    MakeContext = Callable[[], library.Context]


def ignore(_: Any) -> None:
    """Take a message."""


def talk(context: library.Context) -> None:
    library.Node("talker", context=context).create_publisher(String, "chatter", 1)
    library.Node("listener", context=context).create_subscription(String, "chatter", ignore, 1)


def test_text(make_context: MakeContext, zbot_command: Command) -> None:
    talk(make_context())
    assert zbot_command("graph").out == "/talker -> [/chatter] -> /listener\n"
    assert zbot_command("graph", "--show", "nodes").out == (
        "/listener\n/talker\n/talker -> /listener  (/chatter)\n"
    )


def test_json(make_context: MakeContext, zbot_command: Command) -> None:
    talk(make_context())
    found = json.loads(zbot_command("graph", "--json").out)
    assert found["nodes"] == ["/listener", "/talker"]
    assert [topic["name"] for topic in found["topics"]] == ["/chatter"]
    assert {"from": "/talker", "to": "/chatter", "topic": None} in found["edges"]


def test_what_looks_wrong_is_said(make_context: MakeContext, zbot_command: Command) -> None:
    context = make_context()
    talk(context)
    node = library.Node("lost", context=context)
    node.create_subscription(String, "chater", ignore, 1)
    node.create_subscription(Int32, "chatter", ignore, 1)
    text = zbot_command("graph").out
    assert "nobody publishes /chater: is /chatter meant?" in text
    assert "two types cannot hear each other: std_msgs/msg/Int32, std_msgs/msg/String" in text


def test_nobody(domain: int, zbot_command: Command) -> None:
    assert domain
    result = zbot_command("graph")
    assert (result.code, result.out) == (0, "no node is running\n")


def test_watch_prints_each_change(make_context: MakeContext, start: Callable[..., Any]) -> None:
    context = make_context()
    talk(context)
    watching = start("zbot", "graph", "--watch")
    watching.wait_for("/talker -> [/chatter] -> /listener")
    library.Node("late", context=context).create_publisher(String, "news", 1)
    watching.wait_for("/late -> [/news] -> (nobody)")
    watching.stop()
