"""The description of topics, services and actions that the commands share."""

from __future__ import annotations

import re

import pytest

from tests.unit.tokens import endpoint_token
from zbot.graph.snapshot import Snapshot
from zbot.wire.tokens import EndpointToken, EntityKind, NodeToken
from zbot_cli.domain.kinds import ACTION, KINDS, SERVICE, TOPIC, Kind
from zbot_cli.errors import CommandError

SET_BOOL = "std_srvs/srv/SetBool"
FIBONACCI = "example_interfaces/action/Fibonacci"


def service(
    name: str, kind: EntityKind = EntityKind.SERVICE, type_name: str = SET_BOOL
) -> EndpointToken:
    return endpoint_token(name, kind=kind, type_name=type_name)


def action(name: str) -> EndpointToken:
    return service(f"{name}/_action/send_goal", type_name=f"{FIBONACCI}_SendGoal")


NODE = NodeToken(domain=0, zid="a", nid=1, namespace="/", node="talker")
GRAPH = Snapshot(
    (
        NODE,
        endpoint_token("/chatter"),
        endpoint_token("/chatter", kind=EntityKind.SUBSCRIPTION),
        endpoint_token("/_hidden"),
        endpoint_token("/both"),
        endpoint_token("/both", type_name="std_msgs/msg/Int64"),
        service("/lamp"),
        service("/wanted", EntityKind.CLIENT),
        action("/fibonacci"),
    )
)


def test_the_counts_of_a_listing_are_those_of_the_kind() -> None:
    assert TOPIC.facts(GRAPH, "/chatter", ["std_msgs/msg/String"]) == {
        "name": "/chatter",
        "types": ["std_msgs/msg/String"],
        "publisher_count": 1,
        "subscription_count": 1,
    }
    for kind, name in ((SERVICE, "/lamp"), (ACTION, "/fibonacci")):
        facts = kind.facts(GRAPH, name, [])
        assert (facts["server_count"], facts["client_count"]) == (1, 0)


@pytest.mark.parametrize(
    ("kind", "word", "found"),
    [
        (TOPIC, "std_msgs/String", ["/both", "/chatter"]),
        (SERVICE, SET_BOOL, ["/lamp"]),
        (ACTION, "example_interfaces/Fibonacci", ["/fibonacci"]),
    ],
)
def test_names_are_found_by_type(kind: Kind, word: str, found: list[str]) -> None:
    assert kind.with_type(GRAPH, word, include_hidden=False) == found


def test_a_hidden_name_is_found_on_request() -> None:
    assert "/_hidden" in TOPIC.with_type(GRAPH, "std_msgs/msg/String", include_hidden=True)


def test_a_service_without_server_has_a_type_but_is_not_listed() -> None:
    assert SERVICE.types_of(GRAPH, "/wanted") == [SET_BOOL]
    assert SERVICE.listed_type(GRAPH, "/wanted") is None
    assert SERVICE.only_type(GRAPH, "/wanted") == SET_BOOL


@pytest.mark.parametrize(
    ("kind", "name", "guess"),
    [
        (TOPIC, "/chater", "/chatter"),
        (SERVICE, "/lam", "/lamp"),
        (ACTION, "/fibonaci", "/fibonacci"),
    ],
)
def test_an_unknown_name_is_an_error_with_a_similar_name(kind: Kind, name: str, guess: str) -> None:
    with pytest.raises(CommandError, match=f"^Unknown {kind.word} '{name}'$") as caught:
        kind.types_of(GRAPH, name)
    assert caught.value.hint == f"did you mean '{guess}'?"


@pytest.mark.parametrize(
    ("kind", "name", "told"),
    [
        (TOPIC, "/lamp", "/lamp is a service and no topic: type zbot service info /lamp"),
        (TOPIC, "/talker", "/talker is a node and no topic: type zbot node info /talker"),
        (SERVICE, "/fibonacci", "/fibonacci is an action and no service: type zbot action info .*"),
    ],
)
def test_a_name_of_another_kind_is_told(kind: Kind, name: str, told: str) -> None:
    with pytest.raises(CommandError, match="Unknown") as caught:
        kind.types_of(GRAPH, name)
    assert re.fullmatch(told, caught.value.hint)


def test_several_types_are_an_error_that_says_what_to_type() -> None:
    with pytest.raises(CommandError, match=r"^Cannot echo topic ./both., as it contains") as caught:
        TOPIC.only_type(GRAPH, "/both")
    example = "zbot topic echo /both std_msgs/msg/Int64"
    assert caught.value.hint == f"add the type that you mean, e.g. {example}"


def test_the_type_on_a_command_line_is_told_from_the_values() -> None:
    assert SERVICE.split(["std_srvs/SetBool", "{data: true}"]) == (SET_BOOL, ["{data: true}"])
    assert SERVICE.split(["{data: true}"]) == (None, ["{data: true}"])


@pytest.mark.parametrize(
    ("kind", "text"),
    [
        (TOPIC, "The passed message type is invalid"),
        (SERVICE, "The passed type is not a service"),
        (ACTION, "The passed action type is invalid"),
    ],
)
def test_a_type_of_another_kind_is_an_error_in_the_words_of_ros2(kind: Kind, text: str) -> None:
    other = "std_srvs/srv/Empty" if kind is not SERVICE else "std_msgs/msg/Empty"
    with pytest.raises(CommandError, match=f"^{text}$"):
        kind.resolve_type(other)


def test_each_kind_has_the_class_of_its_values() -> None:
    types = {"topic": "std_msgs/msg/String", "service": SET_BOOL, "action": FIBONACCI}
    names = [KINDS[word].values_class(name).__name__ for word, name in types.items()]
    assert names == ["String", "SetBool_Request", "Fibonacci_Goal"]
