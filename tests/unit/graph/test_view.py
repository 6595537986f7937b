from __future__ import annotations

from itertools import count

import pytest

from tests.unit.tokens import STRING, endpoint_token
from zbot.graph.dot import dot
from zbot.graph.filters import InvalidFilterError, compile_filter
from zbot.graph.snapshot import Snapshot
from zbot.graph.view import BoxKind, Edge, Filters, Grouping, Mode, limited, view
from zbot.wire.tokens import EndpointToken, EntityKind, NodeToken

_numbers = count(1)


def node(name: str) -> NodeToken:
    return NodeToken(domain=0, zid="a", nid=next(_numbers), namespace="/", node=name)


def end(kind: EntityKind, node_name: str, topic: str, type_name: str = STRING) -> EndpointToken:
    return endpoint_token(topic, kind=kind, node=node_name, type_name=type_name)


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


def test_active_shows_only_topics_with_publishers_and_subscriptions() -> None:
    assert names(Mode.ACTIVE) == ["/chatter"]


def test_nodes_only_labels_the_arrows() -> None:
    drawn = view(TALKING, Mode.NODES)
    assert not drawn.boxes
    assert drawn.edges == (Edge("/talker", "/listener", "/chatter"),)


def test_filters_leave_topics_out() -> None:
    assert names(filters=Filters(debug=False)) == ["/chatter", "/count", "/rosout"]
    assert names(filters=Filters(dead_sinks=True)) == ["/chatter"]
    assert names(filters=Filters(leaf_topics=True)) == ["/chatter"]


def test_topics_of_hidden_nodes_are_hidden() -> None:
    snapshot = Snapshot((node("_zbot_cli_echo_1"), subscribes("_zbot_cli_echo_1", "/chatter")))
    assert view(snapshot) == view(Snapshot(()))
    assert view(snapshot, filters=Filters(hidden=False)).nodes == ("/_zbot_cli_echo_1",)


def test_filters_include_and_leave_out_as_in_rqt_graph() -> None:
    tokens = [node(name) for name in ("talker", "talker_2", "listener")]
    snapshot = Snapshot(tuple(tokens))

    def left(text: str) -> list[str]:
        return list(view(snapshot, filters=Filters(nodes=text)).nodes)

    everybody = ["/listener", "/talker", "/talker_2"]
    assert left("") == left("/") == left(" , ") == left("-") == everybody
    assert left("/talker") == ["/talker"]
    assert left("/talk.*") == ["/talker", "/talker_2"]
    assert left("-/talker") == ["/listener", "/talker_2"]
    assert left("-/talk.* , -/nobody") == ["/listener"]
    assert left("/talk.*,-/talker_2") == ["/talker"]
    assert left("alker.*") == []  # expressions match from the start, as in rqt_graph


def test_no_name_takes_a_filter_long() -> None:
    r"""`re` needs years for this name."""
    passes = compile_filter(r"/(\w+/?)+x$")
    assert not passes("/robot1/local_costmap/costmap_raw/updates_of_the_whole_map")
    assert passes("/robot1/local_costmap/costmap_raw/updates_of_the_whole_matrix")


@pytest.mark.parametrize("text", ["/(?=a)b", "/a" * 2_000])
def test_a_filter_that_may_take_long_is_refused(text: str) -> None:
    with pytest.raises(InvalidFilterError):
        compile_filter(text)


def test_an_invalid_filter_is_refused() -> None:
    with pytest.raises(InvalidFilterError, match=r"invalid filter '/a\('"):
        view(TALKING, filters=Filters(topics="/x,-/a("))


def test_problems_are_found_with_all_nodes_of_a_topic() -> None:
    drawn = view(TALKING, Mode.ACTIVE, Filters(nodes="/talker", leaf_topics=True))
    assert drawn.nodes == ("/talker",)
    assert drawn.edges == (Edge("/talker", "/chatter", is_publishing=True),)
    assert not view(TALKING, filters=Filters(nodes="/nobody")).topics


def test_left_out_names_are_listed() -> None:
    assert view(TALKING).left_out == ("/rosout",)
    assert view(TALKING, filters=Filters(nodes="-/talker")).left_out == (
        "/count",
        "/rosout",
        "/talker",
    )


@pytest.mark.parametrize("mode", [Mode.ALL, Mode.NODES])
def test_a_crowd_is_drawn_in_part(mode: Mode) -> None:
    crowd = [f"node_{number:04}" for number in range(400)]
    tokens: list[NodeToken | EndpointToken] = [node(name) for name in crowd]
    tokens += [publishes(name, f"/t_{name}_{number}") for name in crowd for number in range(3)]
    tokens += [subscribes(name, "/tf") for name in crowd] + [publishes(crowd[0], "/tf")]
    whole = view(Snapshot(tuple(tokens)), mode)
    part = limited(whole)
    assert (len(part.nodes), part.nodes[0]) == (300, "/node_0000")
    assert len(part.topics) <= 600
    assert len(part.edges) <= 2000
    names = [*part.nodes, *(topic.name for topic in part.topics), *part.left_out]
    topics = [topic.name for topic in whole.topics]
    assert sorted(names) == sorted([*whole.nodes, *topics, *whole.left_out])
    assert limited(part) == part


def test_debug_leaves_tools_out_but_no_student_s_node() -> None:
    snapshot = Snapshot(tuple(node(name) for name in ("rviz2", "rqt_gui", "clock_face", "monitor")))
    assert view(snapshot).nodes == ("/clock_face", "/monitor")
    assert len(view(snapshot, filters=Filters(debug=False)).nodes) == 4


def test_transforms_are_one_box_two_boxes_or_hidden() -> None:
    tokens = (
        node("base"),
        node("map"),
        publishes("base", "/tf"),
        publishes("map", "/tf_static"),
        subscribes("map", "/tf"),
    )
    snapshot = Snapshot(tokens)
    [box] = view(snapshot).boxes
    assert (box.kind, box.name, box.stands_for) == (BoxKind.TF, "/tf", ("/tf", "/tf_static"))
    assert (box.publishers, box.subscriptions) == (("/base", "/map"), ("/map",))
    assert len(view(snapshot, grouping=Grouping(tf=False)).boxes) == 2
    assert not view(snapshot, filters=Filters(tf=True)).boxes


def test_the_forms_of_an_image_are_one_box() -> None:
    forms = [f"/camera/image{form}" for form in ("", "/compressed", "/theora")]
    snapshot = Snapshot((node("camera"), *(publishes("camera", form) for form in forms)))
    assert [box.name for box in view(snapshot).boxes] == ["/camera/image/image_topics"]
    assert len(view(snapshot, grouping=Grouping(images=False)).boxes) == 3


def action(node_name: str, name: str, kind: EntityKind) -> EndpointToken:
    return end(kind, node_name, f"{name}/_action/send_goal", "a/action/Go_SendGoal")


def test_an_action_is_a_box_between_clients_and_servers() -> None:
    served = (
        node("server"),
        node("client"),
        action("server", "/go", EntityKind.SERVICE),
        publishes("server", "/go/_action/feedback", "a/action/Go_FeedbackMessage"),
        publishes("server", "/go/_action/status", "action_msgs/msg/GoalStatusArray"),
        action("client", "/go", EntityKind.CLIENT),
    )
    [box] = view(Snapshot(served)).boxes
    assert (box.key, box.types) == ("a:/go", ("a/action/Go",))
    assert (box.publishers, box.subscriptions) == (("/client",), ("/server",))
    assert {edge.is_both_ways for edge in view(Snapshot(served)).edges} == {True}


def test_a_misspelt_action_is_marked() -> None:
    tokens = (
        node("a"),
        action("a", "/rotate_absolute", EntityKind.SERVICE),
        action("a", "/rotate_absolut", EntityKind.CLIENT),
    )
    boxes = {box.name: box for box in view(Snapshot(tokens)).boxes}
    assert boxes["/rotate_absolut"].problem == (
        "nobody serves /rotate_absolut; did you mean '/rotate_absolute'?"
    )


def test_frames_are_namespaces_down_to_a_level() -> None:
    deep = view(Snapshot(()), grouping=Grouping(namespaces=2))
    assert deep.frames_of("/a/b/c/d") == ("/a", "/a/b")
    assert deep.frames_of("/a/b") == ("/a",)
    assert deep.frames_of("/a") == ()
    assert view(Snapshot(()), grouping=Grouping(namespaces=0)).frames_of("/a/b") == ()


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


def test_problems_are_listed_in_every_mode() -> None:
    snapshot = Snapshot((*TALKING.tokens, node("lost"), subscribes("lost", "/chater")))
    for mode in Mode:
        assert view(snapshot, mode).problems == (
            "nobody publishes /chater; did you mean '/chatter'?",
        )
    assert not view(snapshot, filters=Filters(nodes="-/lost")).problems


def test_dot_has_different_keys_for_a_topic_and_a_node_of_the_same_name() -> None:
    drawn = view(Snapshot((node("ping"), publishes("ping", "/ping"), subscribes("ping", "/ping"))))
    text = dot(drawn)
    assert '"n:/ping" -> "t:/ping";' in text
    assert '"t:/ping" -> "n:/ping";' in text
    assert '"t:/ping" [label="/ping", shape=box];' in text


def test_dot_frames_namespaces() -> None:
    drawn = view(Snapshot((node("a"), publishes("a", "/robot/arm/joint"))))
    text = dot(drawn)
    assert text.index('subgraph "cluster_/robot" {') < text.index('subgraph "cluster_/robot/arm" {')
    assert text.count("{") == text.count("}") == 3
