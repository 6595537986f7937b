"""Tests of the numbers of nodes and endpoints."""

from __future__ import annotations

from dataclasses import replace

import pytest

from tests.unit.tokens import endpoint_token
from zbot.graph import entity_numbers
from zbot.graph.entity_numbers import EntityNumbers
from zbot.qos import QoSProfile
from zbot.wire.tokens import EntityKind, NodeToken

NODE = NodeToken(domain=0, zid="a", nid=0, namespace="/", node="talker")
TOPIC = endpoint_token("/chatter", eid=0)


def test_entities_that_exist_together_have_different_numbers() -> None:
    numbers = EntityNumbers()
    tokens = [numbers.numbered(TOPIC) for _ in range(3)]
    node = numbers.numbered(NODE)
    assert sorted([*(token.eid for token in tokens), node.nid]) == [0, 1, 2, 3]
    assert len({token.key for token in tokens}) == 3


def test_an_equal_entity_gets_the_former_key() -> None:
    numbers = EntityNumbers()
    first, node = numbers.numbered(TOPIC), numbers.numbered(NODE)
    numbers.release(first)
    numbers.release(node)
    assert numbers.numbered(TOPIC).key == first.key
    assert numbers.numbered(NODE).key == node.key


@pytest.mark.parametrize(
    "change",
    [
        {"name": "/news"},
        {"nid": 3},
        {"node": "other"},
        {"kind": EntityKind.SUBSCRIPTION},
        {"qos": QoSProfile(depth=11)},
        {"type_hash": "RIHS01_1"},
    ],
    ids=str,
)
def test_another_entity_gets_another_number(change: dict[str, object]) -> None:
    numbers = EntityNumbers()
    first = numbers.numbered(TOPIC)
    numbers.release(first)
    other = numbers.numbered(replace(TOPIC, key="", **change))  # type: ignore[arg-type]
    assert other.eid != first.eid


def test_an_equal_endpoint_continues_the_numbers_of_messages() -> None:
    numbers = EntityNumbers()
    first = numbers.numbered(TOPIC)
    send = numbers.message_numbers(first)
    assert [send(), send()] == [1, 2]
    numbers.release(first)
    assert numbers.message_numbers(numbers.numbered(TOPIC))() == 3
    assert numbers.message_numbers(numbers.numbered(TOPIC))() == 1


def test_the_oldest_free_numbers_are_forgotten(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(entity_numbers, "_MOST_DESCRIPTIONS", 2)
    numbers = EntityNumbers()
    topics = [replace(TOPIC, key="", name=f"/topic{number}") for number in range(3)]
    used = [numbers.numbered(topic) for topic in topics]
    for token in used:
        numbers.message_numbers(token)()
        numbers.release(token)
    again = [numbers.numbered(topic) for topic in topics]
    assert [token.eid for token in again] == [3, 1, 2]
    assert [numbers.message_numbers(token)() for token in again] == [1, 2, 2]


def test_a_publisher_is_kept_for_an_equal_endpoint() -> None:
    numbers, publisher = EntityNumbers(), object()
    first = numbers.numbered(TOPIC)
    assert numbers.kept(first) is None
    numbers.keep(first, publisher)
    numbers.release(first)
    again = numbers.numbered(TOPIC)
    assert numbers.kept(again) is publisher
    assert numbers.kept(again) is None


def test_few_publishers_are_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(entity_numbers, "_MOST_KEPT", 1)
    numbers = EntityNumbers()
    tokens = [numbers.numbered(TOPIC) for _ in range(2)]
    for token in tokens:
        numbers.keep(token, token.eid)
    assert [numbers.kept(token) for token in tokens] == [None, 1]
