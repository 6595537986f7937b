"""Tests of bridges whose robot, laptop or neighbour ends and comes back."""

from __future__ import annotations

import os
import signal
from functools import partial
from typing import TYPE_CHECKING

from tests.integration.bridge.conftest import eventually, needs_ros2
from tests.integration.bridge.test_topics import STRING, Inbox, as_hex, bridges, texts
from zbot import Node

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin, Start
    from tests.integration.bridge.conftest import Bridges, Peers

pytestmark = needs_ros2()

LAPTOP = """
import threading
import zbot
from zbot.interfaces import get_message, get_service

zbot.init()
node = zbot.Node("laptop")
node.create_publisher(get_message("std_msgs/msg/String"), "/drive", 10)

def answer(request, response):
    print("asked", flush=True)
    threading.Event().wait()

node.create_service(get_service("std_srvs/srv/SetBool"), "/door", answer)
zbot.spin(node)
"""


def test_a_killed_robot_comes_back(
    make_context: MakeContext, spin: Spin, peer: Peers, bridge: Bridges
) -> None:
    node = Node("laptop", context=make_context())
    inbox = Inbox(node, "/pose")
    spin(node)
    bridge()
    for text in ("first", "second"):
        robot = peer()
        robot.advertise(topic="/pose", type="std_msgs/msg/String")
        assert eventually(partial(robot.subscriber_count, topic="/pose"))
        robot.publish(topic="/pose", data=as_hex(text))
        assert eventually(partial(inbox.has, text))
        os.kill(robot.process.pid, signal.SIGKILL)
        robot.process.wait(10)


def test_a_killed_node_of_zbot_leaves_ros_2_and_the_others_go_on(
    make_context: MakeContext, spin: Spin, peer: Peers, bridge: Bridges, start: Start
) -> None:
    robot, other = peer(), Node("other", context=make_context())
    inbox = Inbox(other, "/scan")
    spin(other)
    robot.advertise(topic="/scan", type="std_msgs/msg/String")
    robot.listen(topic="/horn", type="std_msgs/msg/String")
    horn = other.create_publisher(STRING, "/horn", 10)
    program = bridge()
    for round_ in range(2):  # it comes back
        laptop = start(source=LAPTOP)
        assert eventually(lambda: robot.publisher_count(topic="/drive") == 1)
        assert robot.begin_call(name="/door", data=True)
        laptop.wait_for("asked", 20)
        laptop.process.kill()
        program.wait_for("/door: a node of ROS 2 called this service, and the call failed", 20)
        assert eventually(lambda: robot.publisher_count(topic="/drive") == 0)
        assert eventually(lambda: not robot.has_server(name="/door"))

        def goes_on(text: str = f"after {round_}") -> bool:
            robot.publish(topic="/scan", data=as_hex(text))
            horn.publish(STRING(data=text))
            return text in inbox.texts and text in texts(robot, "/horn")

        assert eventually(goes_on)


def test_a_killed_bridge_is_replaced(
    make_context: MakeContext, spin: Spin, peer: Peers, bridge: Bridges
) -> None:
    robot, node = peer(), Node("laptop", context=make_context())
    inbox = Inbox(node, "/pose")
    spin(node)
    robot.advertise(topic="/pose", type="std_msgs/msg/String")
    for text in ("first", "second"):
        program = bridge()

        def arrives(text: str = text) -> bool:
            robot.publish(topic="/pose", data=as_hex(text))
            return text in inbox.texts

        assert eventually(arrives)
        program.process.kill()
        program.process.wait(10)
        assert eventually(lambda: not node.get_publishers_info_by_topic("/pose"))


def test_the_second_bridge_takes_over(
    make_context: MakeContext, spin: Spin, peer: Peers, bridge: Bridges
) -> None:
    robot, node = peer(), Node("laptop", context=make_context())
    inbox = Inbox(node, "/pose")
    publisher = node.create_publisher(STRING, "/drive", 10)
    spin(node)
    robot.advertise(topic="/pose", type="std_msgs/msg/String")
    robot.listen(topic="/drive", type="std_msgs/msg/String")
    first = bridge()
    assert eventually(lambda: node.get_publishers_info_by_topic("/pose"))
    bridge()
    assert eventually(lambda: len(bridges(robot.nodes())) == 2)
    assert len(node.get_publishers_info_by_topic("/pose")) == 1
    first.process.kill()

    def passes() -> bool:
        robot.publish(topic="/pose", data=as_hex("here"))
        publisher.publish(STRING(data="go"))
        return "here" in inbox.texts and "go" in texts(robot, "/drive")

    assert eventually(passes)


def test_ctrl_c_ends_the_bridge_and_clears_the_graph(
    make_context: MakeContext, peer: Peers, bridge: Bridges
) -> None:
    robot, node = peer(), Node("laptop", context=make_context())
    robot.advertise(topic="/pose", type="std_msgs/msg/String")
    program = bridge()
    assert eventually(lambda: node.get_publishers_info_by_topic("/pose"))
    assert program.stop(signal.SIGINT, 10) == 0
    assert "Traceback" not in program.output
    assert eventually(lambda: not node.get_publishers_info_by_topic("/pose"))
    assert eventually(lambda: not bridges(robot.nodes()))
