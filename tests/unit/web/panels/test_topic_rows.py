from __future__ import annotations

from tests.unit.tokens import STRING, endpoint_token
from zbot.graph.snapshot import Snapshot
from zbot.web.panels.topics.topic_rows import FoldedRow, folded, nodes_of, topic_rows
from zbot.wire.tokens import EndpointToken, EntityKind

FLOAT = "std_msgs/msg/Float32"
OWN = "/_zbot_web_1"
NAMES = ["/chatter", "/robot1/arm/angle", "/robot1/arm/force", "/robot1/scan", "/robot2/scan"]


def end(node: str, topic: str, type_name: str = STRING, *, publishes: bool = True) -> EndpointToken:
    namespace, _, name = node.rpartition("/")
    kind = EntityKind.PUBLISHER if publishes else EntityKind.SUBSCRIPTION
    return endpoint_token(
        topic, kind=kind, namespace=namespace or "/", node=name, type_name=type_name
    )


def test_topics_are_listed_with_their_nodes_in_natural_order() -> None:
    graph = Snapshot(
        (
            end("/b", "/robot10/x"),
            end("/a", "/robot2/x"),
            end("/c", "/robot2/x", publishes=False),
            end("/space/d", "/robot2/x", publishes=False),
        )
    )
    first, second = topic_rows(graph, OWN)
    assert (first.name, second.name) == ("/robot2/x", "/robot10/x")
    assert (first.publishers, first.subscriptions) == (("/a",), ("/c", "/space/d"))
    assert first.types == (STRING,)


def test_long_numbers_and_digits_of_other_alphabets_have_an_order() -> None:
    names = ["/a2", "/a10", f"/a{'9' * 5000}", "/a²", "/a٣", "/b007", "/b8"]
    rows = topic_rows(Snapshot(tuple(end("/n", name) for name in reversed(names))), OWN)
    found = [row.name for row in rows]
    assert [name for name in found if name.isascii()] == [name for name in names if name.isascii()]
    assert sorted(found) == sorted(names)


def test_the_nodes_of_one_topic_are_those_of_its_row() -> None:
    graph = Snapshot(
        (
            end("/b", "/x"),
            end("/a", "/x"),
            end("/a", "/other"),
            end("/c", "/x", publishes=False),
            end(OWN, "/x", publishes=False),
        )
    )
    assert nodes_of(graph, "/x", OWN) == (("/a", "/b"), ("/c",))
    assert nodes_of(graph, "/lost", OWN) == ((), ())


def test_endpoints_of_the_page_are_left_out_and_those_of_commands_are_listed() -> None:
    graph = Snapshot(
        (
            end("/_zbot_cli_pub_7", "/x"),
            end(OWN, "/x", publishes=False),
            end(OWN, "/only_mine", publishes=False),
        )
    )
    (row,) = topic_rows(graph, OWN)
    assert (row.name, row.publishers, row.subscriptions) == ("/x", ("/_zbot_cli_pub_7",), ())


def test_rows_have_type_clashes_and_guesses() -> None:
    graph = Snapshot(
        (
            end("/a", "/chatter"),
            end("/b", "/chatter", FLOAT, publishes=False),
            end("/c", "/chater", publishes=False),
        )
    )
    typo, clash = topic_rows(graph, OWN)
    assert (typo.guess, typo.has_clash) == ("/chatter", False)
    assert (clash.guess, clash.has_clash) == (None, True)
    assert clash.types == (FLOAT, STRING)


def test_a_namespace_with_several_names_is_one_row() -> None:
    rows = folded(NAMES, opened=())
    assert [row.name for row in rows] == ["/chatter", "/robot1/", "/robot2/scan"]
    assert rows[1].names == ("/robot1/arm/angle", "/robot1/arm/force", "/robot1/scan")


def test_an_open_namespace_shows_its_names_and_its_own_namespaces() -> None:
    assert folded(NAMES, opened={"/robot1/"})[2:] == [
        FoldedRow("/robot1/arm/", 1, ("/robot1/arm/angle", "/robot1/arm/force")),
        FoldedRow("/robot1/scan", 1),
        FoldedRow("/robot2/scan", 0),
    ]


def test_a_namespace_inside_a_closed_one_stays_closed() -> None:
    assert folded(NAMES, opened={"/robot1/arm/"}) == folded(NAMES, opened=())


def test_namespaces_with_one_child_are_one_row() -> None:
    names = ["/chatter", "/house/robot/left", "/house/robot/right"]
    assert folded(names, ())[1].name == "/house/robot/"


def test_a_namespace_of_all_names_is_no_row() -> None:
    assert [row.name for row in folded(["/r/a", "/r/b/c", "/r/b/d"], ())] == ["/r/a", "/r/b/"]


def test_no_names_are_no_rows() -> None:
    assert folded([], ()) == []
