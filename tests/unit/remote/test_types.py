"""Search for types that only other nodes know."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

from tests.unit.tokens import endpoint_token
from zbot.graph.snapshot import Snapshot
from zbot.interfaces import get_interface, register_spec
from zbot.interfaces.parser import parse
from zbot.node.service_types import DESCRIPTION_SERVICE
from zbot.remote import types
from zbot.remote.types import TypeSearch, UnknownTypeError
from zbot.wire.tokens import EndpointToken, EntityKind

if TYPE_CHECKING:
    from collections.abc import Callable


class FakeDomain:
    """Domain of nodes that have no definitions. `asked` has the keys of their services."""

    def __init__(self) -> None:
        self.asked: list[str] = []
        self.tokens: list[EndpointToken] = []
        self._listeners: list[Callable[[EndpointToken, bool], None]] = []
        graph = SimpleNamespace(
            snapshot=lambda: Snapshot(tuple(self.tokens)), add_listener=self._listeners.append
        )
        self.context: Any = SimpleNamespace(graph=graph, wait_for_peers=lambda: None)

    def add_node(self, name: str, type_name: str) -> None:
        service, service_hash = DESCRIPTION_SERVICE
        self.tokens += [
            endpoint_token("/text", zid=name, type_name=type_name),
            endpoint_token(
                f"/{name}/get_type_description",
                zid=name,
                kind=EntityKind.SERVICE,
                type_name=service,
                type_hash=service_hash,
                key=name,
            ),
        ]

    def lose_all(self) -> None:
        for token in self.tokens:
            for listener in self._listeners:
                listener(token, False)
        self.tokens = []

    def request(self, _context: Any, provider: Any, _name: str, *, timeout_s: float) -> list[Any]:
        assert timeout_s > 0
        self.asked.append(provider.service.key)
        return []


@pytest.fixture
def domain(monkeypatch: pytest.MonkeyPatch) -> FakeDomain:
    fake = FakeDomain()
    monkeypatch.setattr(types, "request_definitions", fake.request)
    return fake


def test_nodes_that_were_asked_in_vain_are_not_asked_again(domain: FakeDomain) -> None:
    search, name = TypeSearch(domain.context), "lost_robot/msg/Text"
    domain.add_node("a", name)
    for _ in range(2):
        assert isinstance(search.search(name), UnknownTypeError)
    assert domain.asked == ["a"]
    domain.add_node("talker", "std_msgs/msg/String")
    assert isinstance(search.failure(name), UnknownTypeError)
    domain.add_node("b", name)
    assert search.failure(name) is None
    assert isinstance(search.search(name), UnknownTypeError)
    assert domain.asked == ["a", "a", "b"]


def test_a_node_that_comes_back_is_asked_again(domain: FakeDomain) -> None:
    search, name = TypeSearch(domain.context), "suspended_robot/msg/Text"
    domain.add_node("a", name)
    assert isinstance(search.search(name), UnknownTypeError)
    domain.lose_all()
    domain.add_node("a", name)
    assert search.failure(name) is None


def test_a_type_that_is_learned_in_another_way_is_found(domain: FakeDomain) -> None:
    search, name = TypeSearch(domain.context), "found_robot/msg/Text"
    assert isinstance(search.search(name), UnknownTypeError)
    register_spec(parse(name, "int32 number\n"))
    assert search.failure(name) is None
    assert search.search(name) is None
    assert get_interface(name)(number=3).number == 3
    assert domain.asked == []
