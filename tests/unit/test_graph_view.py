from __future__ import annotations

from itertools import count

from zbot.graph import Snapshot
from zbot.graph_view import Edge, Filters, Mode, dot, view
from zbot.qos import QoSProfile
from zbot.wire.tokens import EndpointToken, EntityKind, NodeToken

STRING = "std_msgs/msg/String"
_numbers = count(1)


def node(name: str) -> NodeToken:
    return NodeToken(domain=0, zid="a", nid=next(_numbers), namespace="/", node=name)


def end(kind: EntityKind, node_name: str, topic: str, type_name: str = STRING) -> EndpointToken:
    return EndpointToken(
        domain=0,
        zid="a",
        nid=1,
        eid=next(_numbers),
        kind=kind,
        namespace="/",
        node=node_name,
        name=topic,
        type_name=type_name,
        type_hash="RIHS01_0",
        qos=QoSProfile(depth=1),
    )


def publishes(node_name: str, topic: str, type_name: str = STRING) -> EndpointToken:
    return end(EntityKind.PUBLISHER, node_name, topic, type_name)


def subscribes(node_name: str, topic: str, type_name: str = STRING) -> EndpointToken:
    return end(EntityKind.SUBSCRIPTION, node_name, topic, type_name)


TALKING = Snapshot(
    (
        node("talker"),
        node("listener"),
        publishes("talker", "/chatter"),
        publishes("talker", "/count"),
        publishes("talker", "/rosout"),
        subscribes("listener", "/chatter"),
    )
)


def names(mode: Mode = Mode.ALL, filters: Filters | None = None) -> list[str]:
    return [box.name for box in view(TALKING, mode, filters).boxes]


def test_all_shows_each_topic_with_its_arrows() -> None:
    drawn = view(TALKING)
    assert drawn.nodes == ("/listener", "/talker")
    assert [box.name for box in drawn.boxes] == ["/chatter", "/count"]
    assert drawn.edges == (
        Edge("/chatter", "/listener"),
        Edge("/talker", "/chatter", is_publishing=True),
        Edge("/talker", "/count", is_publishing=True),
    )


def test_active_shows_only_topics_that_carry_messages() -> None:
    assert names(Mode.ACTIVE) == ["/chatter"]


def test_nodes_only_labels_the_arrows() -> None:
    drawn = view(TALKING, Mode.NODES)
    assert not drawn.boxes
    assert drawn.edges == (Edge("/talker", "/listener", "/chatter"),)


def test_filters_leave_topics_out() -> None:
    assert names(filters=Filters(debug=False)) == ["/chatter", "/count", "/rosout"]
    assert names(filters=Filters(dead_sinks=True)) == ["/chatter"]
    assert names(filters=Filters(leaf_topics=True)) == ["/chatter"]


def test_hidden_nodes_take_their_topics_with_them() -> None:
    snapshot = Snapshot((node("_zbot_cli_echo_1"), subscribes("_zbot_cli_echo_1", "/chatter")))
    assert view(snapshot) == view(Snapshot(()))
    assert view(snapshot, filters=Filters(hidden=False)).nodes == ("/_zbot_cli_echo_1",)


def test_two_types_are_a_clash() -> None:
    other = subscribes("listener", "/count", "std_msgs/msg/Int32")
    boxes = {box.name: box for box in view(Snapshot((*TALKING.tokens, other))).boxes}
    assert boxes["/count"].has_clash
    assert not boxes["/chatter"].has_clash


def test_a_misspelt_topic_is_marked() -> None:
    other = subscribes("listener", "/chater")
    boxes = {box.name: box for box in view(Snapshot((*TALKING.tokens, other))).boxes}
    assert boxes["/chater"].guess == "/chatter"
    assert boxes["/chatter"].guess is None


def test_dot_tells_a_topic_from_a_node_of_the_same_name() -> None:
    drawn = view(Snapshot((node("ping"), publishes("ping", "/ping"), subscribes("ping", "/ping"))))
    text = dot(drawn)
    assert '"n:/ping" -> "t:/ping";' in text
    assert '"t:/ping" -> "n:/ping";' in text
    assert '"t:/ping" [label="/ping", shape=box];' in text
