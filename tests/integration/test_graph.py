"""Tests of names and of the graph of all nodes."""

from __future__ import annotations

import signal
import sys
import threading
import time
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import allowed, wait_until
from tests.integration.conftest import await_match
from zbot.errors import (
    InvalidHandleError,
    InvalidNamespaceError,
    InvalidNodeNameError,
    InvalidTopicNameError,
)
from zbot.graph.endpoint_info import TopicEndpointTypeEnum
from zbot.node.errors import NodeNameError, UnknownNodeError
from zbot.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSPresetProfiles,
    QoSProfile,
    as_profile,
)
from zbot.time import Duration
from zbot.wire.tokens import EndpointToken, NodeToken

from std_msgs.msg import Float32, String
from std_srvs.srv import Trigger

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import MakeContext, Start

    MakeNode = Callable[..., zbot.Node]

NODE = """
import zbot
from std_msgs.msg import String

with zbot.init():
    node = zbot.Node("guest")
    node.create_publisher(String, "chatter", 10)
    print("ready")
    zbot.spin(node)
"""


@pytest.fixture
def context(make_context: MakeContext) -> zbot.Context:
    return make_context()


@pytest.fixture
def make_node(context: zbot.Context) -> MakeNode:
    made: list[zbot.Node] = []  # a node without a reference leaves the graph

    def make(name: str, *words: str, **options: Any) -> zbot.Node:
        arguments = ["--ros-args", *words] if words else None
        made.append(zbot.Node(name, context=context, cli_args=arguments, **options))
        return made[-1]

    return make


@pytest.fixture
def observer(make_context: MakeContext) -> zbot.Node:
    return zbot.Node("observer", context=make_context(), enable_rosout=False)


# -- a node's own names ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("namespace", "expected"),
    [
        (None, ("robot", "/", "/robot")),
        ("", ("robot", "/", "/robot")),
        ("/", ("robot", "/", "/robot")),
        ("fleet", ("robot", "/fleet", "/fleet/robot")),
        ("/fleet/north", ("robot", "/fleet/north", "/fleet/north/robot")),
    ],
)
def test_a_node_is_in_its_namespace(
    make_node: MakeNode, namespace: str | None, expected: tuple[str, str, str]
) -> None:
    node = make_node("robot", namespace=namespace)
    found = (node.get_name(), node.get_namespace(), node.get_fully_qualified_name())
    assert found == expected
    assert node.get_logger().name == expected[2][1:].replace("/", ".")


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["-r", "__node:=other"], "/other"),
        (["-r", "__name:=other"], "/other"),
        (["-r", "__ns:=/fleet"], "/fleet/robot"),
        (["-r", "__ns:=/fleet", "-r", "__node:=other"], "/fleet/other"),
        (["-r", "robot:__node:=other"], "/other"),
        (["-r", "somebody:__node:=other"], "/robot"),
    ],
)
def test_the_command_line_renames_a_node(
    make_node: MakeNode, words: list[str], expected: str
) -> None:
    assert make_node("robot", *words).get_fully_qualified_name() == expected


@pytest.mark.parametrize(
    ("topic", "expected"),
    [
        ("scan", "/fleet/scan"),
        ("/scan", "/scan"),
        ("~/scan", "/fleet/robot/scan"),
        ("~", "/fleet/robot"),
        ("front/scan", "/fleet/front/scan"),
        ("{node}/scan", "/fleet/robot/scan"),
        ("_hidden", "/fleet/_hidden"),
    ],
)
def test_topics_resolve_against_node_and_namespace(
    make_node: MakeNode, observer: zbot.Node, topic: str, expected: str
) -> None:
    node = make_node("robot", namespace="fleet")
    assert node.resolve_topic_name(topic) == expected
    assert node.create_publisher(String, topic, 10).topic_name == expected
    assert wait_until(lambda: observer.count_publishers(expected) == 1)


@pytest.mark.parametrize(
    ("rule", "expected"),
    [
        ("chatter:=talk", "/talk"),
        ("/chatter:=/talk", "/talk"),
        ("chatter:=/fleet/talk", "/fleet/talk"),
        ("chatter:=~/talk", "/robot/talk"),
        ("robot:chatter:=talk", "/talk"),
        ("other:chatter:=talk", "/chatter"),
    ],
)
def test_the_command_line_renames_topics(make_node: MakeNode, rule: str, expected: str) -> None:
    node = make_node("robot", "-r", rule)
    assert node.create_subscription(String, "chatter", print, 10).topic_name == expected
    assert node.resolve_topic_name("chatter", only_expand=True) == "/chatter"


def test_the_processes_command_line_applies_to_every_node(domain: int) -> None:
    context = zbot.Context()
    context.init(["program", "--ros-args", "-r", "__ns:=/fleet"], domain_id=domain)
    with context:
        assert zbot.Node("robot", context=context).get_namespace() == "/fleet"
        own = zbot.Node("robot", context=context, use_global_arguments=False)
        assert own.get_namespace() == "/"


@pytest.mark.parametrize(
    ("name", "error"),
    [
        ("", NodeNameError),
        (None, NodeNameError),
        (5, NodeNameError),
        ("two words", InvalidNodeNameError),
        ("1st", InvalidNodeNameError),
        ("a/b", InvalidNodeNameError),
    ],
)
def test_an_invalid_name_is_refused(
    make_node: MakeNode, observer: zbot.Node, name: str, error: type[Exception]
) -> None:
    with pytest.raises(error):
        make_node(name)
    assert observer.get_node_names() == ["observer"]


def test_an_invalid_name_is_shown_with_a_caret(make_node: MakeNode) -> None:
    with pytest.raises(InvalidNodeNameError) as raised:
        make_node("two words")
    assert str(raised.value).splitlines()[-2:] == ["  'two words'", "      ^"]
    with pytest.raises(InvalidNamespaceError):
        make_node("robot", namespace="/a b")
    with pytest.raises(InvalidTopicNameError):
        make_node("robot").create_publisher(String, "my topic", 10)


# -- the whole graph -------------------------------------------------------------------------------


def test_the_graph_lists_nodes_with_their_namespaces(
    make_node: MakeNode, observer: zbot.Node
) -> None:
    make_node("robot", namespace="/fleet")
    make_node("base")
    wanted = [("base", "/"), ("observer", "/"), ("robot", "/fleet")]
    assert wait_until(lambda: sorted(observer.get_node_names_and_namespaces()) == wanted)
    assert sorted(observer.get_node_names()) == ["base", "observer", "robot"]
    names = observer.get_fully_qualified_node_names()
    assert sorted(names) == ["/base", "/fleet/robot", "/observer"]
    enclaves = observer.get_node_names_and_namespaces_with_enclaves()
    assert ("robot", "/fleet", "/") in enclaves


def test_two_nodes_of_one_name_are_both_listed(make_node: MakeNode, observer: zbot.Node) -> None:
    make_node("twin")
    make_node("twin")
    assert wait_until(lambda: observer.get_node_names().count("twin") == 2)


def test_the_first_graph_of_a_new_process_is_complete(
    make_node: MakeNode, make_context: MakeContext
) -> None:
    nodes = [make_node(f"node_{number}") for number in range(10)]
    newcomer = zbot.Node("newcomer", context=make_context())
    assert len(newcomer.get_node_names()) == len(nodes) + 1


def test_the_first_graph_can_have_the_size_of_a_whole_class(
    make_node: MakeNode, make_context: MakeContext
) -> None:
    names = [make_node(f"robot_{number}").get_name() for number in range(60)]
    newcomer = zbot.Node("newcomer", context=make_context())
    assert set(newcomer.get_node_names()) == {*names, "newcomer"}


def test_the_first_graph_is_complete_while_processes_come_and_go(
    make_context: MakeContext, start: Start
) -> None:
    nodes = [start(source=NODE.replace('"guest"', f'"guest_{number}"')) for number in range(3)]
    for node in nodes:
        node.wait_for("ready")
    for _ in range(15):
        newcomer = make_context()
        assert len(newcomer.graph.snapshot().publishers("/chatter")) == 3
        newcomer.shutdown()


def test_the_graph_lists_topics_with_their_types(make_node: MakeNode, observer: zbot.Node) -> None:
    node = make_node("robot")
    node.create_publisher(Float32, "temperature", 10)
    node.create_subscription(String, "temperature", print, 10)
    node.create_subscription(String, "_hidden", print, 10)
    wanted = {
        "/temperature": ["std_msgs/msg/Float32", "std_msgs/msg/String"],
        "/_hidden": ["std_msgs/msg/String"],
        "/rosout": ["rcl_interfaces/msg/Log"],
        "/parameter_events": ["rcl_interfaces/msg/ParameterEvent"],
    }
    assert wait_until(lambda: dict(observer.get_topic_names_and_types()) == wanted)


def test_the_graph_lists_each_nodes_endpoints(make_node: MakeNode, observer: zbot.Node) -> None:
    node = make_node("robot", namespace="/fleet", enable_rosout=False)
    node.create_publisher(Float32, "temperature", 10)
    node.create_subscription(String, "orders", print, 10)
    assert wait_until(lambda: observer.count_subscribers("/fleet/orders") == 1)
    published = observer.get_publisher_names_and_types_by_node("robot", "/fleet")
    assert ("/fleet/temperature", ["std_msgs/msg/Float32"]) in published
    assert observer.get_subscriber_names_and_types_by_node("robot", "/fleet") == [
        ("/fleet/orders", ["std_msgs/msg/String"])
    ]
    assert observer.get_client_names_and_types_by_node("robot", "/fleet") == []
    with pytest.raises(UnknownNodeError, match="there is no node /fleet/robo; the nodes are:"):
        observer.get_publisher_names_and_types_by_node("robo", "/fleet")


def test_counts_resolve_names_as_topics_do(make_node: MakeNode) -> None:
    node = make_node("robot", "-r", "chatter:=talk", namespace="/fleet")
    node.create_publisher(String, "chatter", 10)
    node.create_publisher(String, "chatter", 10)
    assert node.count_publishers("chatter") == 2
    assert node.count_publishers("/fleet/talk") == 2
    assert node.count_publishers("/talk") == 0
    assert node.count_subscribers("chatter") == 0


def test_a_query_with_an_invalid_name_is_refused(observer: zbot.Node) -> None:
    said = "topic name '42' is invalid: topic name token must not start with a number"
    for ask in (observer.count_publishers, observer.get_subscriptions_info_by_topic):
        with pytest.raises(ValueError, match=said):
            ask("42")
    with pytest.raises(ValueError, match="service name 'a b' is invalid"):
        observer.count_clients("a b")


def test_endpoint_infos_have_node_type_and_quality_of_service(
    make_node: MakeNode, observer: zbot.Node
) -> None:
    node = make_node("robot", namespace="/fleet")
    profile = QoSProfile(depth=7, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    publisher = node.create_publisher(String, "/map", profile)
    node.create_subscription(String, "/map", print, 3)
    assert wait_until(lambda: observer.count_subscribers("/map") == 1)
    (info,) = observer.get_publishers_info_by_topic("/map")
    assert (info.node_name, info.node_namespace) == ("robot", "/fleet")
    assert info.topic_type == "std_msgs/msg/String"
    assert info.endpoint_type is TopicEndpointTypeEnum.PUBLISHER
    assert info.qos_profile.depth == 7
    assert info.qos_profile.durability is DurabilityPolicy.TRANSIENT_LOCAL
    assert bytes(info.endpoint_gid) == publisher.token.gid
    (info,) = observer.get_subscriptions_info_by_topic("/map")
    assert (info.qos_profile.depth, info.endpoint_type) == (3, TopicEndpointTypeEnum.SUBSCRIPTION)
    assert observer.get_publishers_info_by_topic("/nothing") == []


PROFILES = {
    "depth": 10,
    "system default": QoSPresetProfiles.SYSTEM_DEFAULT.value,
    "sensor data": QoSPresetProfiles.SENSOR_DATA.value,
    "best available": QoSPresetProfiles.BEST_AVAILABLE.value,
    "keep all": QoSProfile(history=HistoryPolicy.KEEP_ALL),
    "all policies": QoSProfile(
        depth=3,
        durability=DurabilityPolicy.TRANSIENT_LOCAL,
        lifespan=Duration(seconds=2),
        deadline=Duration(seconds=1),
        liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,
        liveliness_lease_duration=Duration(seconds=3),
    ),
}


@pytest.mark.parametrize("profile", PROFILES.values(), ids=PROFILES)
def test_a_node_sees_its_own_profiles_as_others_see_them(
    make_node: MakeNode, observer: zbot.Node, profile: QoSProfile | int
) -> None:
    node = make_node("robot")
    publisher = node.create_publisher(String, "/map", profile)
    subscription = node.create_subscription(String, "/map", print, profile)
    own = [
        *node.get_publishers_info_by_topic("/map"),
        *node.get_subscriptions_info_by_topic("/map"),
    ]
    assert wait_until(
        lambda: (observer.count_publishers("/map"), observer.count_subscribers("/map")) == (1, 1)
    )
    seen = [
        *observer.get_publishers_info_by_topic("/map"),
        *observer.get_subscriptions_info_by_topic("/map"),
    ]
    assert own == seen
    assert all("SYSTEM_DEFAULT" not in str(endpoint) for endpoint in own)
    assert publisher.qos_profile == subscription.qos_profile == as_profile(profile)


def test_the_graph_is_sorted_again_only_after_a_change(make_node: MakeNode) -> None:
    node = make_node("node")
    publisher = node.create_publisher(String, "chatter", 10)
    subscription = node.create_subscription(String, "chatter", print, 10)
    before = node.context.graph.snapshot()
    assert publisher.get_subscription_count() == 1
    assert node.context.graph.snapshot() is before
    node.destroy_subscription(subscription)
    assert publisher.get_subscription_count() == 0


def test_an_endpoint_of_another_type_is_not_counted(make_node: MakeNode) -> None:
    node = make_node("node")
    publisher = node.create_publisher(String, "chatter", 10)
    other = node.create_subscription(Float32, "chatter", print, 10)
    assert (publisher.get_subscription_count(), other.get_publisher_count()) == (0, 0)


# -- change ----------------------------------------------------------------------------------------


def test_waiting_for_a_node_ends_when_it_comes(make_node: MakeNode, observer: zbot.Node) -> None:
    late = threading.Timer(0.02, lambda: make_node("late", namespace="/fleet"))
    late.start()
    begin = time.monotonic()
    assert observer.wait_for_node("/fleet/late", timeout=allowed(5))
    assert time.monotonic() - begin < allowed(2)
    late.join()
    assert observer.wait_for_node("fleet/late", timeout=0)


def test_waiting_for_a_node_ends_at_the_timeout(observer: zbot.Node) -> None:
    begin = time.monotonic()
    assert not observer.wait_for_node("/nobody", timeout=0.02)
    assert time.monotonic() - begin < allowed(1)


def test_waiting_for_a_node_ends_with_the_context(observer: zbot.Node) -> None:
    found: list[bool] = []
    wait = threading.Thread(
        target=lambda: found.append(observer.wait_for_node("/nobody", 3600)), daemon=True
    )
    wait.start()
    assert wait_until(lambda: bool(observer.context.graph._waiting))
    observer.context.shutdown()
    wait.join(allowed(10))
    assert found == [False]


def test_listeners_are_notified_of_the_present_graph_and_of_every_change(
    make_node: MakeNode, observer: zbot.Node
) -> None:
    class Listener:
        def __init__(self) -> None:
            self.heard: list[tuple[str, bool]] = []

        def on_change(self, token: NodeToken | EndpointToken, appeared: bool) -> None:
            if isinstance(token, EndpointToken) and token.name == "/chatter":
                self.heard.append((token.kind.value, appeared))

    node = make_node("robot")
    publisher = node.create_publisher(String, "chatter", 10)
    assert wait_until(lambda: observer.count_publishers("/chatter") == 1)
    listener = Listener()
    observer.context.graph.watch()
    observer.context.graph.add_listener(listener.on_change)
    assert wait_until(lambda: listener.heard == [("MP", True)])
    node.create_subscription(String, "chatter", print, 10)
    publisher.destroy()
    expected = [("MP", True), ("MS", True), ("MP", False)]
    assert wait_until(lambda: listener.heard == expected)
    observer.context.graph.remove_listener(listener.on_change)
    node.destroy_node()
    assert wait_until(lambda: observer.count_subscribers("/chatter") == 0)
    assert listener.heard == expected


def test_a_context_receives_only_the_tokens_that_it_follows(
    make_node: MakeNode, observer: zbot.Node
) -> None:
    robot = make_node("robot")
    mine = observer.create_subscription(String, "chatter", print, 10)
    robot.create_publisher(String, "chatter", 10)
    robot.create_publisher(String, "other", 10)
    graph = observer.context.graph

    def others() -> list[tuple[str, str]]:
        tokens = [token for token in graph.known() if token.zid != mine.token.zid]
        return [(token.kind.value, getattr(token, "name", "")) for token in tokens]

    assert wait_until(lambda: others() == [("MP", "/chatter")])
    names = {token.name for token in graph.query().endpoints}
    assert {"/chatter", "/other"} <= names
    assert others() == [("MP", "/chatter")]


def test_a_context_that_follows_many_topics_watches_the_graph(
    make_node: MakeNode, observer: zbot.Node
) -> None:
    for number in range(60):
        observer.create_subscription(String, f"chatter_{number}", print, 10)
    make_node("robot").create_publisher(String, "other", 10)
    graph = observer.context.graph
    assert wait_until(
        lambda: any(getattr(entity, "name", "") == "/other" for entity in graph.known())
    )


def test_a_destroyed_node_leaves_the_graph(make_node: MakeNode, observer: zbot.Node) -> None:
    node = make_node("robot")
    node.create_publisher(String, "chatter", 10)
    node.create_subscription(String, "chatter", print, 10)
    assert observer.wait_for_node("/robot", timeout=allowed(5))
    node.destroy_node()
    assert wait_until(lambda: observer.get_node_names() == ["observer"])
    topics = [name for name, _ in observer.get_topic_names_and_types()]
    assert topics == ["/parameter_events"]
    with pytest.raises(InvalidHandleError, match="/robot was destroyed"):
        node.create_timer(1.0, print)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no SIGKILL")
def test_a_killed_process_leaves_the_graph_in_a_second(start: Start, observer: zbot.Node) -> None:
    assert observer.get_node_names() == ["observer"]
    guest = start(source=NODE)
    guest.wait_for("ready")
    assert observer.wait_for_node("/guest", timeout=allowed(5))
    guest.stop(signal.SIGKILL)
    assert wait_until(lambda: observer.get_node_names() == ["observer"], timeout_s=1)
    assert wait_until(lambda: observer.count_publishers("/chatter") == 0, timeout_s=1)


def test_the_nodes_of_a_finished_process_leave_the_graph(start: Start, observer: zbot.Node) -> None:
    guest = start(source=NODE)
    guest.wait_for("ready")
    assert observer.wait_for_node("/guest", timeout=allowed(5))
    guest.stop()
    assert wait_until(lambda: observer.get_node_names() == ["observer"], timeout_s=1)


def test_counts_follow_the_other_nodes_endpoints(talker: zbot.Node, listener: zbot.Node) -> None:
    publisher = talker.create_publisher(String, "chatter", 10)
    assert publisher.get_subscription_count() == 0
    first = listener.create_subscription(String, "chatter", print, 10)
    second = listener.create_subscription(String, "chatter", print, 10)
    await_match(publisher, 2)
    assert wait_until(lambda: first.get_publisher_count() == 1)
    listener.destroy_subscription(second)
    await_match(publisher, 1)
    listener.context.shutdown()
    await_match(publisher, 0)


def test_endpoints_keep_their_given_names(make_context: MakeContext) -> None:
    node = zbot.Node("named", namespace="/ns", context=make_context())
    publisher = node.create_publisher(String, "~/news", 1)
    subscription = node.create_subscription(String, "news", lambda _: None, 1)
    assert (publisher.topic, publisher.topic_name) == ("~/news", "/ns/named/news")
    assert (subscription.topic, subscription.topic_name) == ("news", "/ns/news")
    client = node.create_client(Trigger, "help")
    service = node.create_service(Trigger, "/help", lambda _, response: response)
    assert (client.srv_name, client.service_name) == ("help", "/ns/help")
    assert (service.srv_name, service.service_name) == ("/help", "/help")
