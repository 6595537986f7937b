"""Tests of `zbot interface header`, and of a plain Zenoh program with the keys that it prints."""

from __future__ import annotations

import json
import re
import threading
from contextlib import contextmanager
from typing import TYPE_CHECKING

import pytest
import zenoh

import zbot
from tests.integration.conftest import packed
from zbot.transport.config import MEETING_PORT

from std_srvs.srv import SetBool

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from tests.cli.conftest import Command
    from tests.conftest import MakeContext, Spin

own_dialect = pytest.mark.own_dialect("the board speaks zbot's own dialect")


def test_a_c_header_is_the_default_and_can_be_written_to_a_file(
    zbot_command: Command, tmp_path: Path
) -> None:
    printed = zbot_command("interface", "header", "std_msgs/msg/String", "std_srvs/srv/SetBool").out
    assert printed.startswith("/* Messages of ROS 2 for microcontrollers, in C99.")
    assert '#define std_msgs__msg__String__DDS_NAME "std_msgs::msg::dds_::String_"' in printed
    assert "} std_srvs__srv__SetBool_Request;" in printed
    assert printed.isascii()
    file = tmp_path / "messages.h"
    words = ("--c", "-o", str(file), "std_msgs/msg/String", "std_srvs/srv/SetBool")
    assert zbot_command("interface", "header", *words).out == ""
    assert file.read_bytes() == printed.encode()


def test_a_module_for_micropython(zbot_command: Command) -> None:
    printed = zbot_command("interface", "header", "--micropython", "std_msgs/msg/String").out
    module: dict[str, type] = {}
    exec(printed, module)
    assert module["String"]().__dict__ == {"data": ""}


@pytest.mark.parametrize(
    ("words", "error"),
    [
        (("--c", "--micropython", "std_msgs/msg/String"), "choose one of --c, --micropython and"),
        (("--token", "a", "std_msgs/msg/String", "std_msgs/msg/Bool"), "--token needs one type"),
        (("--token", "a", "std_srvs/srv/SetBool", "--kind", "publisher"), "SetBool has no publish"),
        (("--token", "a", "std_msgs/msg/String", "--kind", "talker"), "Unknown kind 'talker'"),
        (("--token", "a", "example_interfaces/action/Fibonacci"), "does not support actions"),
        (("--token", "a b", "std_msgs/msg/String"), "invalid topic name"),
        (("std_msgs/msg/Strin",), "Interface 'msg/Strin' not found in package 'std_msgs'"),
    ],
)
def test_wrong_words_are_one_sentence(
    zbot_command: Command, words: tuple[str, ...], error: str
) -> None:
    result = zbot_command("interface", "header", *words)
    assert result.code != 0
    assert error.lower() in result.err.lower()


class Board:
    """Plain Zenoh session that declares the keys which the command prints for a topic."""

    def __init__(self, zbot_command: Command, domain: int, *words: str) -> None:
        text = zbot_command("interface", "header", "--token", *words).out
        self.keys = dict(re.findall(r"(data|node|token): +(\S+)", text))
        config = zenoh.Config()
        config.insert_json5("mode", '"client"')
        config.insert_json5("connect/endpoints", f'["tcp/127.0.0.1:{MEETING_PORT + domain}"]')
        self.session = zenoh.open(config)
        zid = str(self.session.info.zid())
        self.tokens = [
            self.session.liveliness().declare_token(self.keys[name].replace("/ZID/", f"/{zid}/"))
            for name in ("node", "token")
        ]


@contextmanager
def publishing(board: Board, value: object) -> Iterator[None]:
    """Publish a message a hundred times a second, without attachment and without encoding."""
    is_over = threading.Event()
    publisher = board.session.declare_publisher(board.keys["data"])

    def publish() -> None:
        while not is_over.wait(0.01):
            publisher.put(packed({"data": value}))

    thread = threading.Thread(target=publish)
    thread.start()
    try:
        yield
    finally:
        is_over.set()
        thread.join()


@own_dialect
def test_a_board_with_the_printed_keys_is_a_node_with_a_topic(
    make_context: MakeContext, zbot_command: Command
) -> None:
    domain = make_context().get_domain_id()
    board = Board(zbot_command, domain, "temperature", "std_msgs/msg/Float32")
    with board.session, publishing(board, 23.5):
        assert "/board\n" in zbot_command("node", "list").out
        listed = zbot_command("topic", "list", "-t").out
        assert "/temperature [std_msgs/msg/Float32]\n" in listed
        assert zbot_command("topic", "echo", "--once", "/temperature").out == "data: 23.5\n---\n"
        info = zbot_command("topic", "info", "-v", "/temperature").out
        assert "Node name: board" in info
        assert "Topic type hash: RIHS01_7170d3d8f841f7be" in info
    assert "/board\n" not in zbot_command("node", "list").out


@own_dialect
def test_a_board_in_a_namespace_gets_messages_and_serves_requests(
    make_context: MakeContext, zbot_command: Command, spin: Spin
) -> None:
    context = make_context()
    words = ("led", "std_srvs/srv/SetBool", "--node", "/robot1/board")
    board = Board(zbot_command, context.get_domain_id(), *words)
    assert board.keys["data"] == f"{context.get_domain_id()}/robot1/led"

    def serve(query: zenoh.Query) -> None:
        assert query.payload is not None
        is_on = query.payload.to_bytes() == packed({"data": True})
        reply = {"success": is_on, "message": "led"}
        query.reply(query.key_expr, packed(reply))

    with board.session:
        board.session.declare_queryable(board.keys["data"], serve, complete=True)
        listed = json.loads(zbot_command("service", "list", "-t", "--json").out)
        assert "/robot1/led" in str(listed)
        node = zbot.Node("laptop", context=context)
        spin(node)
        response = node.create_client(SetBool, "/robot1/led").call(SetBool.Request(data=True))
        assert (response.success, response.message) == (True, "led")
