"""Tests of the work that the warnings about typical mistakes need."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

from tests.unit.tokens import endpoint_token
from zbot.node.diagnostics import Diagnostics
from zbot.transport import running_programs
from zbot.wire.dialect import NATIVE
from zbot.wire.tokens import NodeToken

if TYPE_CHECKING:
    from collections.abc import Callable

    import pytest

    from zbot.graph.snapshot import Token


class Bench:
    """Diagnostics of a context without Zenoh's network. Their thread runs when a test says so."""

    def __init__(self) -> None:
        self.tokens: list[Token] = []
        self._threads: list[Callable[[], None]] = []
        context: Any = SimpleNamespace(
            graph=SimpleNamespace(add_listener=bool, follow=bool, known=lambda: tuple(self.tokens)),
            add_waker=bool,
            start_thread=lambda _name, run: self._threads.append(run),
            dialect=NATIVE,
            is_running=True,
            is_student=False,
            get_domain_id=lambda: 17,
        )
        self.diagnostics = Diagnostics(context)

    def check(self, tokens: list[Token]) -> None:
        """Add own tokens, and check all of them at once."""
        self.tokens += tokens
        for token in tokens:
            self.diagnostics.add(token, token.node)
        self._threads.pop()()


def node_token(name: str, number: int) -> NodeToken:
    return NodeToken(domain=0, zid="a", nid=number, namespace="/", node=name)


def test_only_topics_of_one_name_are_compared(monkeypatch: pytest.MonkeyPatch) -> None:
    pairs: list[tuple[str, str]] = []
    monkeypatch.setattr(
        Diagnostics,
        "_compare_pair",
        lambda _self, mine, other, _logger: pairs.append((mine.name, other.name)),
    )
    Bench().check([endpoint_token(f"/topic{number}") for number in range(100)])
    assert pairs
    assert all(mine == other for mine, other in pairs)


def test_the_running_programs_are_read_once_for_many_nodes(monkeypatch: pytest.MonkeyPatch) -> None:
    reads: list[int] = []

    def running() -> list[Any]:
        reads.append(1)
        return []

    monkeypatch.setattr(running_programs, "running", running)
    Bench().check([node_token(f"node{number}", number) for number in range(100)])
    assert len(reads) == 1


def test_two_own_nodes_of_one_name_and_two_types_of_a_topic_are_told(logged: list[Any]) -> None:
    Bench().check(
        [
            *(node_token("arm", number) for number in range(2)),
            endpoint_token("/chatter", node="arm"),
            endpoint_token("/chatter", node="arm", type_name="std_msgs/msg/Int32"),
        ]
    )
    texts = [record.message for record in logged]
    assert any("there is another node named /arm" in text for text in texts)
    assert any("/chatter has two types" in text for text in texts)
