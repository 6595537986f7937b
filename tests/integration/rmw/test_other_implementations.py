"""ROS 2's dialect beside two other implementations of it, which share no code with zbot.

Set ZBOT_RMW_PYTHON to a Python with `pip install pyzeros zenoh-ros2-sdk`.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from tests.conftest import Program, wait_until
from zbot.transport.rmw_meeting import RmwRouter

from example_interfaces.srv import AddTwoInts
from std_msgs.msg import String

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from tests.conftest import Spin
    from tests.integration.rmw.conftest import MakeNode

    StartOther = Callable[[str], Program]

PYTHON = os.environ.get("ZBOT_RMW_PYTHON", "")
PROGRAM = Path(__file__).parents[2] / "programs" / "remote" / "other_ros2.py"
#: pyzeros compiles C at its first message, into the current folder.
FOLDER = Path(PYTHON).parent
START_S = 100.0

pytestmark = [
    pytest.mark.skipif(not PYTHON, reason="ZBOT_RMW_PYTHON names no Python"),
    pytest.mark.timeout(300),
]


@pytest.fixture(params=["pyzeros", "sdk"])
def library(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture(params=["with a router", "without a router"])
def start_other(
    request: pytest.FixtureRequest,
    library: str,
    endpoint: str,
    free_domain: int,
    monkeypatch: pytest.MonkeyPatch,
) -> Iterator[StartOther]:
    """Return a function that starts a program of a library. zbot's nodes are linked to it."""
    running: list[Program] = []
    override = f'mode="peer";connect/endpoints=["{endpoint}"];listen/endpoints=[]'
    router = None
    if request.param == "with a router":
        router = RmwRouter([endpoint], []).open()
        override = override.replace("[]", '["tcp/127.0.0.1:0"]')
    else:
        monkeypatch.setenv("ZENOH_CONFIG_OVERRIDE", override)
        override = f'mode="peer";connect/endpoints=[];listen/endpoints=["{endpoint}"]'

    def start(role: str) -> Program:
        variables = {"ROS_DOMAIN_ID": str(free_domain), "ZENOH_CONFIG_OVERRIDE": override}
        leaks = {"PYTHONPATH", "RMW_IMPLEMENTATION"}
        clean = {name: value for name, value in os.environ.items() if name not in leaks}
        words = [PYTHON, "-u", str(PROGRAM), library, role]
        running.append(Program(words, FOLDER, clean | variables))
        running[-1].wait_for("ready", START_S)
        return running[-1]

    yield start
    for program in running:
        program.process.kill()
        program.process.wait(10)
    if router is not None:
        router.close()


def test_its_messages_arrive(start_other: StartOther, make_node: MakeNode, spin: Spin) -> None:
    start_other("talk")
    heard: list[str] = []
    node = make_node()
    node.create_subscription(String, "chatter", lambda message: heard.append(message.data), 10)
    spin(node)
    assert wait_until(lambda: "hi" in heard, START_S)
    (info,) = node.get_publishers_info_by_topic("/chatter")
    assert (info.node_name, info.topic_type) == ("other", "std_msgs/msg/String")


def test_it_gets_messages(start_other: StartOther, make_node: MakeNode) -> None:
    other = start_other("listen")
    publisher = make_node().create_publisher(String, "chatter", 10)
    assert wait_until(lambda: publisher.get_subscription_count() == 1, 20)

    def is_heard() -> bool:
        publisher.publish(String(data="héé€"))
        return any("heard héé€" in line for line in other.new_lines())

    assert wait_until(is_heard, START_S)


def test_its_service_is_called(start_other: StartOther, make_node: MakeNode) -> None:
    start_other("serve")
    client = make_node().create_client(AddTwoInts, "add")
    assert client.wait_for_service(20)
    assert client.call(AddTwoInts.Request(a=40, b=2), START_S).sum == 42


def test_it_calls_a_service(start_other: StartOther, make_node: MakeNode, spin: Spin) -> None:
    def add(request: Any, response: Any) -> Any:
        response.sum = request.a + request.b
        return response

    node = make_node()
    node.create_service(AddTwoInts, "add", add)
    spin(node)
    start_other("call").wait_for("sum 42", START_S)
