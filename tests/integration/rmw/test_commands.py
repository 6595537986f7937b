"""Commands of zbot in ROS 2's dialect, beside a node that knows only the wire."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from tests.cli.command import zbot
from tests.conftest import wait_until
from tests.integration.conftest import lines_about
from tests.integration.rmw.ros2_node import ADD, STRING, Ros2Node, string, text_of
from zbot.interfaces import get_message
from zbot.interfaces.parser import parse
from zbot.interfaces.registry import register_spec
from zbot.node.errors import ServiceError
from zbot.transport.config import MEETING_PORT
from zbot.transport.rmw_choice import RMW_VARIABLE
from zbot.transport.rmw_meeting import RmwRouter

from example_interfaces.srv import AddTwoInts
from std_msgs.msg import String

if TYPE_CHECKING:
    from tests.conftest import Spin, Start
    from tests.integration.rmw.conftest import MakeNode
    from zbot.log.record import Record
    from zbot.node.node import Node

READER = """
import zbot
from zbot.interfaces import get_message
from zbot.interfaces.parser import parse
from zbot.interfaces.registry import register_spec

register_spec(parse("ship_msgs/msg/Depth", "float32 metres\\nstring ship\\n"))
zbot.init()
node = zbot.Node("sounder")
node.create_publisher(get_message("ship_msgs/msg/Depth"), "depth", 10)
zbot.spin(node)
"""


def test_lists_show_the_nodes_topics_and_types_of_ros_2(plain: Ros2Node) -> None:
    plain.publisher("/chatter")
    assert wait_until(lambda: "/chatter" in zbot("topic", "list").out)
    assert zbot("node", "list").out.splitlines() == ["/plain"]
    assert "/chatter [std_msgs/msg/String]" in zbot("topic", "list", "-t").out
    info = zbot("topic", "info", "-v", "/chatter").out
    assert f"Topic type hash: {STRING[1]}" in info
    assert "Node name: plain" in info


def test_echo_prints_the_message_of_a_publisher_of_ros_2(plain: Ros2Node, start: Start) -> None:
    echo = start("zbot", "topic", "echo", "--once", "/chatter", "std_msgs/msg/String")
    publisher = plain.publisher("/chatter")

    def is_over() -> bool:
        publisher.put(string("hello"), attachment=plain.attachment())
        return echo.process.poll() is not None

    assert wait_until(is_over, 10)
    assert echo.wait() == 0
    assert "data: hello" in echo.output


def test_pub_reaches_a_subscription_of_ros_2(plain: Ros2Node) -> None:
    samples = plain.subscribe("/chatter")
    assert zbot("topic", "pub", "--once", "/chatter", "std_msgs/msg/String", "data: hi").code == 0
    assert wait_until(lambda: bool(samples))
    assert text_of(samples[0].payload.to_bytes()) == "hi"
    assert samples[0].attachment.to_bytes()[16] == 16


def test_a_service_of_ros_2_is_called(plain: Ros2Node) -> None:
    plain.serve_sum("/add")
    done = zbot("service", "call", "/add", "example_interfaces/srv/AddTwoInts", "{a: 40, b: 2}")
    assert "sum=42" in done.out


@pytest.mark.parametrize("words", [("--rmw", "topic", "list"), ("topic", "list", "--rmw")])
def test_the_option_chooses_the_dialect(
    plain: Ros2Node, words: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    plain.publisher("/chatter")
    monkeypatch.delenv(RMW_VARIABLE)
    assert wait_until(lambda: "/chatter" in zbot(*words).out)
    assert "/chatter" not in zbot("topic", "list").out


def test_an_unknown_middleware_is_one_sentence() -> None:
    done = zbot("--rmw=rmw_pigeon", "topic", "list")
    assert done.code == 1
    assert done.err.count("\n") == 1
    assert "zbot does not speak 'rmw_pigeon'" in done.err


def test_words_of_a_program_are_not_options_of_zbot(
    start: Start, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(RMW_VARIABLE, "")
    source = f"import os, sys; print(sys.argv[1:], repr(os.environ['{RMW_VARIABLE}']))"
    program = start("--rmw", source=source, by_zbot=True)
    program.wait_for("['--rmw'] ''")


def test_a_command_without_a_router_fails_with_one_sentence(endpoint: str) -> None:
    done = zbot("topic", "list")
    assert done.code == 1
    assert done.err.startswith(f"no Zenoh router answers on {endpoint}")
    assert done.err.count("\n") == 1


def test_hub_is_a_router_of_ros_2(
    domain: int, start: Start, monkeypatch: pytest.MonkeyPatch
) -> None:
    address = f"127.0.0.1:{MEETING_PORT + 2000 + domain}"
    hub = start("zbot", "hub", "--rmw", "--listen", address)
    hub.wait_for(f"the router of ROS 2 listens on tcp/{address}")
    monkeypatch.setenv("ZENOH_CONFIG_OVERRIDE", f'connect/endpoints=["tcp/{address}"]')
    assert zbot("topic", "list").code == 0
    second = zbot("hub", "--rmw", "--listen", address)
    assert second.code == 1
    assert "a machine needs one" in second.err
    assert hub.stop() == 0


def test_another_definition_is_told_with_the_fields_that_differ(
    router: str, make_node: MakeNode, spin: Spin, start: Start, logged: list[Record]
) -> None:
    assert router
    register_spec(parse("ship_msgs/msg/Depth", "float64 metres\n"))
    start(source=READER)
    node = make_node()
    node.create_subscription(get_message("ship_msgs/msg/Depth"), "depth", lambda _: None, 10)
    spin(node)
    assert wait_until(lambda: bool(lines_about(logged, "another definition")), 15)
    (line,) = lines_about(logged, "another definition")
    assert "/depth: /sounder has another definition of ship_msgs/msg/Depth" in line
    assert "`metres` is float64 here and float32 there" in line
    assert "`ship` is only there" in line


def test_another_hash_is_told_if_the_node_does_not_tell_its_definition(
    plain: Ros2Node, node: Node, spin: Spin, logged: list[Record]
) -> None:
    plain.publisher("/chatter", (STRING[0], "RIHS01_" + "0" * 64))
    node.create_subscription(String, "chatter", lambda _: None, 10)
    spin(node)
    assert wait_until(lambda: bool(lines_about(logged, "another definition")), 15)
    (line,) = lines_about(logged, "another definition")
    assert "its hash is RIHS01_df668c740... here and RIHS01_000000000... there" in line


def test_doctor_checks_the_router(endpoint: str) -> None:
    with RmwRouter([endpoint], []).open():
        assert "ok    ROS 2 router: it answers" in zbot("doctor").out
    done = zbot("doctor")
    assert done.code == 1
    assert f"FAIL  ROS 2 router: none answers\n      -> no Zenoh router answers on {endpoint}" in (
        done.out
    )


def test_a_service_with_another_definition_is_told(
    plain: Ros2Node, node: Node, start: Start
) -> None:
    plain.announce("SS", "/add", (ADD[0], "RIHS01_" + "0" * 64))
    command = start("zbot", "service", "call", "/add", "example_interfaces/srv/AddTwoInts", "{}")
    command.wait_for("/add: /plain has another definition of example_interfaces/srv/AddTwoInts")
    client = node.create_client(AddTwoInts, "add")
    with pytest.raises(ServiceError, match="/plain has another definition"):
        client.call(AddTwoInts.Request(), 5)
