"""Tests of `zbot foxglove` with a client that speaks Foxglove's websocket protocol."""

from __future__ import annotations

import json
import queue
import signal
import struct
import sys
import threading
from typing import TYPE_CHECKING, Any

import pytest

pytest.importorskip("foxglove", reason="foxglove-sdk is not installed")
pytest.importorskip("websockets", reason="websockets is not installed")

from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect

import zbot
from tests.conftest import allowed, wait_until
from zbot.observer.system import System
from zbot.web.foxglove.channels import Channels
from zbot.web.foxglove.server import _sdk_server
from zbot.wire.serialization import deserialize_message, serialize_message

from example_interfaces.srv import AddTwoInts
from std_msgs.msg import Float64, String

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tests.conftest import MakeContext, Spin, Start

PROTOCOL = "foxglove.sdk.v1"


class App:
    """Client as Foxglove's application is one."""

    def __init__(self, address: str, **options: Any) -> None:
        self.channels: dict[str, dict[str, Any]] = {}
        self.services: dict[str, dict[str, Any]] = {}
        self.parameters: dict[str, Any] = {}
        self.publishers: dict[str, list[str]] = {}
        self.blocks: queue.Queue[bytes] = queue.Queue()
        words: Any = {"subprotocols": [PROTOCOL], **options}
        self._connection = connect(address, **words)
        self.socket: Any = self._connection.__enter__()
        self._thread = threading.Thread(target=self._read, daemon=True)
        self._thread.start()

    def send(self, **message: Any) -> None:
        self.socket.send(json.dumps(message))

    def close(self) -> None:
        self._connection.__exit__(None, None, None)
        self._thread.join(allowed(5))

    def _read(self) -> None:
        try:
            for message in self.socket:
                if isinstance(message, bytes):
                    self.blocks.put(message)
                else:
                    self._note(json.loads(message))
        except ConnectionClosed:
            return

    def _note(self, message: dict[str, Any]) -> None:
        if message["op"] == "advertise":
            self.channels |= {channel["topic"]: channel for channel in message["channels"]}
        elif message["op"] == "unadvertise":
            ids = message["channelIds"]
            self.channels = {
                k: channel for k, channel in self.channels.items() if channel["id"] not in ids
            }
        elif message["op"] == "advertiseServices":
            self.services |= {service["name"]: service for service in message["services"]}
        elif message["op"] == "parameterValues":
            self.parameters |= {
                parameter["name"]: parameter.get("value") for parameter in message["parameters"]
            }
        elif message["op"] == "connectionGraphUpdate":
            found = message["publishedTopics"]
            self.publishers |= {publisher["name"]: publisher["publisherIds"] for publisher in found}


@pytest.fixture
def address(start: Start) -> str:
    program = start("zbot", "foxglove", "--port", "0")
    return program.wait_for("zbot foxglove: ", 20).partition("zbot foxglove: ")[2]


@pytest.fixture
def app(address: str) -> Iterator[App]:
    app = App(address)
    yield app
    app.close()


@pytest.fixture
def robot(make_context: MakeContext, spin: Spin) -> zbot.Node:
    """Return a node with a topic, a service and a parameter."""
    node = zbot.Node("robot", context=make_context())
    node.declare_parameter("speed", 1.0)
    publisher = node.create_publisher(String, "chatter", 10)
    node.create_timer(0.05, lambda: publisher.publish(String(data="hello")))

    def add(request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
        response.sum = request.a + request.b
        return response

    node.create_service(AddTwoInts, "add", add)
    spin(node)
    return node


@pytest.mark.usefixtures("robot")
def test_messages_come_in_cdr_with_their_schema(app: App, robot: zbot.Node) -> None:
    assert wait_until(lambda: "/chatter" in app.channels)
    channel = app.channels["/chatter"]
    assert (channel["encoding"], channel["schemaName"]) == ("cdr", "std_msgs/msg/String")
    assert channel["schemaEncoding"] == "ros2msg"
    assert channel["schema"].strip().endswith("string data")
    assert robot.count_subscribers("/chatter") == 0  # nobody looks
    app.send(op="subscribe", subscriptions=[{"id": 7, "channelId": channel["id"]}])
    block = app.blocks.get(timeout=allowed(10))
    assert struct.unpack("<BI", block[:5]) == (1, 7)
    assert deserialize_message(block[13:], String).data == "hello"
    app.send(op="unsubscribe", subscriptionIds=[7])
    assert wait_until(lambda: robot.count_subscribers("/chatter") == 0)
    app.send(op="subscribeConnectionGraph")
    assert wait_until(lambda: app.publishers.get("/chatter") == ["/robot"])


@pytest.mark.usefixtures("robot")
def test_services_are_called(app: App) -> None:
    assert wait_until(lambda: "/add" in app.services)
    assert "/robot/get_parameters" not in app.services
    data = serialize_message(AddTwoInts.Request(a=2, b=3))
    number = app.services["/add"]["id"]
    app.socket.send(struct.pack("<BIII", 2, number, 5, 3) + b"cdr" + data)
    block = app.blocks.get(timeout=allowed(10))
    assert struct.unpack("<BIII", block[:13]) == (3, number, 5, 3)
    assert deserialize_message(block[16:], AddTwoInts.Response).sum == 5


@pytest.mark.parametrize(
    ("encoding", "data"),
    [("json", b'{"data": 1.5}'), ("cdr", serialize_message(Float64(data=1.5)))],
)
def test_the_app_publishes(
    app: App, make_context: MakeContext, spin: Spin, encoding: str, data: bytes
) -> None:
    heard: list[float] = []
    node = zbot.Node("ear", context=make_context())
    node.create_subscription(Float64, "/speed", lambda message: heard.append(message.data), 10)
    spin(node)
    channel = {"id": 3, "topic": "/speed", "encoding": encoding, "schemaName": "std_msgs/Float64"}
    app.send(op="advertise", channels=[channel])
    assert wait_until(lambda: node.count_publishers("/speed") == 1)
    app.socket.send(struct.pack("<BI", 1, 3) + b"wrong")
    app.socket.send(struct.pack("<BI", 1, 3) + data)
    assert wait_until(lambda: heard == [1.5])
    app.send(op="unadvertise", channelIds=[3])
    assert wait_until(lambda: node.count_publishers("/speed") == 0)


def test_parameters_are_read_and_set(app: App, robot: zbot.Node) -> None:
    assert wait_until(lambda: "/add" in app.services)  # the server knows all services of the robot
    app.send(op="getParameters", parameterNames=[], id="all")
    assert wait_until(lambda: app.parameters.get("/robot.speed") == 1.0)
    # JSON writes 2.0 as 2.
    app.send(op="setParameters", parameters=[{"name": "/robot.speed", "value": 2}], id="set")
    assert wait_until(lambda: robot.get_parameter("speed").value == 2.0)
    assert wait_until(lambda: app.parameters.get("/robot.speed") == 2.0)


def test_a_website_is_refused(address: str, start: Start) -> None:
    with pytest.raises(InvalidStatus, match="403"):
        App(address, origin="https://evil.example")
    App(address, origin="https://app.foxglove.dev").close()
    program = start("zbot", "foxglove", "--port", "0", "--host", "127.0.0.2", "--read-only")
    inside = program.wait_for("zbot foxglove: ", 20).partition("zbot foxglove: ")[2]
    app = App(inside)
    app.close()
    assert app.services == {}


def test_a_wider_address_needs_the_token(start: Start) -> None:
    program = start("zbot", "foxglove", "--port", "0", "--host", "0.0.0.0")
    address = program.wait_for("zbot foxglove: ", 20).partition("zbot foxglove: ")[2]
    here = address.replace("0.0.0.0", "127.0.0.1")
    with pytest.raises(InvalidStatus, match="403"):
        App(here.partition("?")[0])
    App(here).close()


SERVER = """
from zbot.web.foxglove.server import serve

serve("127.0.0.1", 0, read_only=True, origins=(), on_ready=lambda address, _: print(address))
"""


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
def test_a_program_ends_at_ctrl_c_while_a_client_stays(start: Start) -> None:
    program = start(source=SERVER)
    app = App(program.wait_for("ws://"))
    assert program.stop(signal.SIGINT) == -signal.SIGINT  # it keeps Python's own handler
    app.close()


def test_the_graph_is_followed_after_a_defect(
    domain: int,
    make_context: MakeContext,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    shown: list[set[str]] = []

    def update(_self: Channels, graph: Any) -> None:
        shown.append({name for name, _ in graph.topics()})
        if len(shown) == 1:
            raise KeyError("defect")

    monkeypatch.setattr(Channels, "update", update)
    with System(domain_id=domain) as system, _sdk_server(system):
        assert wait_until(lambda: bool(shown))
        zbot.Node("late", context=make_context()).create_publisher(String, "chatter", 10)
        assert wait_until(lambda: "/chatter" in shown[-1])
    assert "KeyError: 'defect'" in capfd.readouterr().err
