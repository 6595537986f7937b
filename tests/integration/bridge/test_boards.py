"""Tests of `zbot hub --boards`. A node that speaks rmw_zenoh stands for a board."""

from __future__ import annotations

import socket
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from tests.integration.bridge.conftest import ONE_SIDE, eventually
from zbot import Node
from zbot.transport.rmw_choice import RMW_ZENOH

from sensor_msgs.msg import Temperature
from std_srvs.srv import SetBool

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin, Start

pytestmark = pytest.mark.own_dialect(ONE_SIDE)

ROS_DOMAIN = 34


def test_one_command_shows_a_board_in_the_domain(
    make_context: MakeContext, spin: Spin, start: Start, monkeypatch: pytest.MonkeyPatch
) -> None:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        address = f"127.0.0.1:{probe.getsockname()[1]}"
    words = ("--boards", "--listen", address, "--ros-domain", str(ROS_DOMAIN))
    hub = start("zbot", "hub", *words)
    hub.wait_for(f"on the board: tcp/{address}", 30)
    monkeypatch.setenv(
        "ZENOH_CONFIG_OVERRIDE", f'mode="client";connect/endpoints=["tcp/{address}"]'
    )
    context = zbot.Context(rmw=RMW_ZENOH)
    context.init([], domain_id=ROS_DOMAIN)
    try:
        check(Node("board", context=context), Node("laptop", context=make_context()), spin)
    finally:
        context.shutdown()
    assert hub.stop() == 0


def check(board: Node, laptop: Node, spin: Spin) -> None:
    inbox: list[Any] = []
    laptop.create_subscription(Temperature, "temperature", inbox.append, 10)
    publisher = board.create_publisher(Temperature, "temperature", 10)
    board.create_service(SetBool, "led", serve)
    spin(board)
    spin(laptop)

    def is_heard() -> bool:
        publisher.publish(Temperature(temperature=23.5))
        return bool(inbox)

    assert eventually(is_heard)
    assert inbox[0].temperature == 23.5
    assert ("board", "/") in laptop.get_node_names_and_namespaces()
    client = laptop.create_client(SetBool, "led")
    assert client.wait_for_service(timeout_sec=20)
    assert client.call(SetBool.Request(data=True)).message == "led of the board"
    assert wait_until(lambda: "/board/get_parameters" in dict(laptop.get_service_names_and_types()))


def serve(request: SetBool.Request, response: SetBool.Response) -> SetBool.Response:
    response.success, response.message = request.data, "led of the board"
    return response
