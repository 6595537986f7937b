"""Tests of topics that the bridge carries to a genuine ROS 2 and back."""

from __future__ import annotations

import random
import threading
from typing import TYPE_CHECKING, Any

from tests.integration.bridge.conftest import eventually, needs_ros2
from tests.unit.wire.random_message import ALPHABET, random_message
from zbot import Node, Parameter, QoSProfile
from zbot.interfaces import MessageSpec, get_message, get_spec, interface_names
from zbot.qos import DurabilityPolicy, ReliabilityPolicy
from zbot.time import Time
from zbot.wire.cdr.codec import cdr_codec_for

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin
    from tests.integration.bridge.conftest import Bridges, GenuinePeer, Peers

pytestmark = needs_ros2()

PACKAGES = [
    "actionlib_msgs", "diagnostic_msgs", "geometry_msgs", "nav_msgs", "sensor_msgs", "shape_msgs",
    "std_msgs", "stereo_msgs", "trajectory_msgs", "visualization_msgs", "action_msgs",
    "builtin_interfaces", "lifecycle_msgs", "rcl_interfaces", "rosgraph_msgs",
    "unique_identifier_msgs",
]  # fmt: skip
TYPES = [
    name
    for package in PACKAGES
    for name in interface_names(package)
    if isinstance(get_spec(name), MessageSpec)
]
STRING: Any = get_message("std_msgs/msg/String")
#: rclpy ends a text at its first NUL.
TEXT = ALPHABET.replace("\0", "")
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def as_hex(text: str) -> str:
    return cdr_codec_for(STRING).encode(STRING(data=text)).hex()


def texts(robot: GenuinePeer, topic: str) -> list[str]:
    """Return the strings that a genuine node has heard. DDS may add padding to the bytes."""
    return [
        cdr_codec_for(STRING).decode(bytes.fromhex(text)).data for text in robot.heard(topic=topic)
    ]


def bridges(nodes: list[str]) -> list[str]:
    return [name for name in nodes if name.startswith("_zbot_bridge_")]


class Inbox:
    """Subscription that keeps what comes."""

    def __init__(self, node: Node, topic: str, cls: Any = STRING, qos: Any = 100) -> None:
        self.messages: list[Any] = []
        self.arrived = threading.Event()
        node.create_subscription(cls, topic, self._take, qos)

    def _take(self, message: Any) -> None:
        self.messages.append(message)
        self.arrived.set()

    @property
    def texts(self) -> list[str]:
        return [message.data for message in self.messages]

    def has(self, text: str) -> bool:
        return text in self.texts


def test_every_type_goes_there_and_back_with_equal_fields(
    make_context: MakeContext, spin: Spin, peer: Peers, bridge: Bridges
) -> None:
    assert len(TYPES) > 140
    robot, node = peer(), Node("laptop", context=make_context())
    bridge()
    chance = random.Random(7)
    pairs = []
    for index, name in enumerate(TYPES):
        robot.echo(type=name, source=f"/there_{index}", target=f"/back_{index}")
        cls = get_message(name)
        publisher = node.create_publisher(cls, f"/there_{index}", 10)
        pairs.append(
            (publisher, Inbox(node, f"/back_{index}", cls), random_message(cls, chance, TEXT))
        )
    spin(node)
    missing = list(range(len(TYPES)))

    def all_are_there() -> bool:
        while missing and robot.publisher_count(topic=f"/there_{missing[-1]}"):
            missing.pop()
        return not missing

    assert eventually(all_are_there, 60)

    def is_back(publisher: Any, inbox: Inbox, message: Any) -> bool:
        if not inbox.messages:
            publisher.publish(message)
        return inbox.arrived.wait(0.5)

    for publisher, inbox, message in pairs:
        assert eventually(lambda: is_back(publisher, inbox, message)), publisher.topic_name  # noqa: B023 - called at once
        assert inbox.messages[0] == message, publisher.topic_name


def test_a_stream_of_the_robot_arrives_in_order(
    make_context: MakeContext, spin: Spin, peer: Peers, bridge: Bridges
) -> None:
    robot, node = peer(), Node("laptop", context=make_context())
    inbox = Inbox(node, "/count", qos=500)
    spin(node)
    bridge()
    robot.advertise(topic="/count", type="std_msgs/msg/String", depth=500)
    assert eventually(lambda: robot.subscriber_count(topic="/count"))
    robot.stream(topic="/count", count=500, hertz=500)
    assert eventually(lambda: "499" in inbox.texts)
    numbers = list(map(int, inbox.texts))
    assert numbers == list(range(numbers[0], 500))


def test_the_graph_shows_the_nodes_of_the_robot(
    make_context: MakeContext, peer: Peers, bridge: Bridges
) -> None:
    robot, node = peer("turtle"), Node("laptop", context=make_context())
    robot.advertise(topic="/pose", type="geometry_msgs/msg/Pose", reliability="best_effort")
    robot.listen(topic="/cmd_vel", type="geometry_msgs/msg/Twist")
    robot.serve_bool(name="/lamp")
    bridge()
    assert eventually(lambda: ("turtle", "/") in node.get_node_names_and_namespaces())
    assert eventually(lambda: node.get_publishers_info_by_topic("/pose"))
    pose = node.get_publishers_info_by_topic("/pose")
    assert [(publisher.node_name, publisher.topic_type) for publisher in pose] == [
        ("turtle", "geometry_msgs/msg/Pose")
    ]
    assert pose[0].qos_profile.reliability is ReliabilityPolicy.BEST_EFFORT
    assert eventually(
        lambda: (
            [
                subscription.node_name
                for subscription in node.get_subscriptions_info_by_topic("/cmd_vel")
            ]
            == ["turtle"]
        )
    )
    assert eventually(
        lambda: (
            node.get_service_names_and_types_by_node("turtle", "/")
            == [("/lamp", ["std_srvs/srv/SetBool"])]
        )
    )
    robot.end()
    assert eventually(lambda: ("turtle", "/") not in node.get_node_names_and_namespaces(), 40)
    assert eventually(lambda: not node.get_publishers_info_by_topic("/pose"))


def test_a_latched_message_reaches_who_comes_later(
    make_context: MakeContext, spin: Spin, peer: Peers, bridge: Bridges
) -> None:
    robot, node = peer(), Node("laptop", context=make_context())
    robot.advertise(topic="/map", type="std_msgs/msg/String", durability="transient_local", depth=1)
    robot.publish(topic="/map", data=as_hex("a map"))
    publisher = node.create_publisher(STRING, "/plan", LATCHED)
    publisher.publish(STRING(data="a plan"))
    bridge()
    assert eventually(lambda: node.get_publishers_info_by_topic("/map"))
    inbox = Inbox(node, "/map", STRING, LATCHED)
    spin(node)
    assert eventually(lambda: inbox.texts == ["a map"])
    robot.listen(topic="/plan", type="std_msgs/msg/String", durability="transient_local", depth=1)
    assert eventually(lambda: texts(robot, "/plan") == ["a plan"])


def test_nothing_comes_back_where_it_came_from(
    make_context: MakeContext, spin: Spin, peer: Peers, bridge: Bridges
) -> None:
    robot, node = peer(), Node("laptop", context=make_context())
    ours, theirs = Inbox(node, "/talk"), "/talk"
    publisher = node.create_publisher(STRING, "/talk", 100)
    robot.advertise(topic=theirs, type="std_msgs/msg/String")
    robot.listen(topic=theirs, type="std_msgs/msg/String", depth=100)
    spin(node)
    bridge("--topics", "/talk")
    assert eventually(lambda: robot.publisher_count(topic=theirs) == 2)
    assert eventually(lambda: node.get_publishers_info_by_topic("/talk")[1:])
    bridge("--topics", "/talk")
    assert eventually(lambda: len(bridges(robot.nodes())) == 2)
    publisher.publish(STRING(data="hello"))
    robot.publish(topic=theirs, data=as_hex("hi"))
    assert eventually(lambda: "hi" in ours.texts and "hello" in texts(robot, theirs))
    before, heard_before = len(ours.texts), len(robot.heard(topic=theirs))
    for number in range(50):
        publisher.publish(STRING(data=f"ours {number}"))
        robot.publish(topic=theirs, data=as_hex(f"theirs {number}"))
    assert eventually(lambda: "theirs 49" in ours.texts)
    assert eventually(lambda: "ours 49" in texts(robot, theirs))
    assert sorted(ours.texts[before:]) == sorted(
        f"{who} {number}" for who in ("ours", "theirs") for number in range(50)
    )
    assert eventually(lambda: len(robot.heard(topic=theirs)) - heard_before == 100)


def test_a_rate_is_kept(
    make_context: MakeContext, spin: Spin, peer: Peers, bridge: Bridges
) -> None:
    robot, node = peer(), Node("laptop", context=make_context())
    inbox = Inbox(node, "/image")
    spin(node)
    bridge("--rate", "/image=10")
    robot.advertise(topic="/image", type="std_msgs/msg/String")
    assert eventually(lambda: robot.subscriber_count(topic="/image"))
    robot.stream(topic="/image", count=200, hertz=100)
    assert eventually(lambda: any(int(text) > 180 for text in inbox.texts))
    assert 15 <= len(inbox.texts) <= 25


def test_only_what_patterns_select_is_carried(
    make_context: MakeContext, peer: Peers, bridge: Bridges
) -> None:
    robot, node = peer(), Node("laptop", context=make_context())
    for topic in ("/camera/image", "/scan"):
        robot.advertise(topic=topic, type="std_msgs/msg/String")
    node.create_publisher(STRING, "/camera/light", 10)
    robot.serve_bool(name="/lamp")
    bridge("--topics", "/camera/*:in")
    assert eventually(lambda: node.get_publishers_info_by_topic("/camera/image"))
    names = dict(node.get_topic_names_and_types())
    assert "/scan" not in names
    assert not robot.publisher_count(topic="/camera/light")
    assert not any(name == "/lamp" for name, _ in node.get_service_names_and_types())


def test_a_prefix_gives_the_robot_a_namespace(
    make_context: MakeContext, spin: Spin, peer: Peers, bridge: Bridges
) -> None:
    robot, node = peer("base"), Node("laptop", context=make_context())
    robot.advertise(topic="/scan", type="std_msgs/msg/String")
    robot.listen(topic="/cmd", type="std_msgs/msg/String")
    inbox = Inbox(node, "/robot1/scan")
    publisher = node.create_publisher(STRING, "/robot1/cmd", 10)
    spin(node)
    bridge("--prefix", "robot1")
    assert eventually(lambda: ("base", "/robot1") in node.get_node_names_and_namespaces())
    assert eventually(lambda: robot.publisher_count(topic="/cmd"))
    assert eventually(lambda: robot.subscriber_count(topic="/scan"))
    robot.publish(topic="/scan", data=as_hex("beep"))
    publisher.publish(STRING(data="go"))
    assert eventually(lambda: inbox.texts == ["beep"])
    assert eventually(lambda: texts(robot, "/cmd") == ["go"])


def test_profiles_that_do_not_fit_and_missing_types_are_told(
    make_context: MakeContext, peer: Peers, bridge: Bridges
) -> None:
    robot, node = peer(), Node("laptop", context=make_context())
    robot.listen(topic="/strict", type="std_msgs/msg/String")
    best_effort = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
    node.create_publisher(STRING, "/strict", best_effort)
    node.create_publisher(get_message("turtlesim/msg/Pose"), "/turtle1/pose", 10)
    program = bridge()
    lines = {program.wait_for("WARN"), program.wait_for("WARN")}
    told = "\n".join(lines)
    assert "/strict: /robot gets no messages of /laptop: publisher reliability" in told
    assert "/turtle1/pose is not carried: this Python has no turtlesim/msg/Pose" in told


def test_the_clock_of_the_robot_is_followed(
    make_context: MakeContext, spin: Spin, peer: Peers, bridge: Bridges
) -> None:
    robot = peer()
    robot.advertise(topic="/clock", type="rosgraph_msgs/msg/Clock", reliability="best_effort")
    simulated = [Parameter("use_sim_time", value=True)]
    node = Node("laptop", context=make_context(), parameter_overrides=simulated)
    spin(node)
    bridge()
    clock: Any = get_message("rosgraph_msgs/msg/Clock")
    stamp = clock(clock=Time(seconds=1234).to_msg())
    data = cdr_codec_for(clock).encode(stamp).hex()

    def is_followed() -> bool:
        robot.publish(topic="/clock", data=data)
        return node.get_clock().now().nanoseconds == 1234 * 10**9

    assert eventually(is_followed)
