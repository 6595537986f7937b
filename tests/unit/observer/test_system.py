"""Test of what a new node or endpoint lets the observer do."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

from tests.unit.tokens import endpoint_token
from zbot.observer.system import System
from zbot.remote.types import UnknownTypeError
from zbot.wire.tokens import NodeToken

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.graph.snapshot import Token


def nothing(_feed: Any) -> None:
    """Do not subscribe."""


class Feed:
    """Topic that a page may watch. It counts the questions whether a page watches it."""

    def __init__(self, topic: str, asked_type: str | None) -> None:
        self.topic, self.asked_type = topic, asked_type
        self.questions = 0

    @property
    def is_wanted(self) -> bool:
        self.questions += 1
        return True


def test_a_new_endpoint_concerns_only_watches_of_its_topic_that_follow_the_type() -> None:
    feeds = {name: Feed(name, None) for name in ("/a", "/b")} | {"/c": Feed("/c", "a/msg/B")}
    tasks: list[Any] = []
    executor = SimpleNamespace(create_task=lambda _function, feed: tasks.append(feed))
    system: Any = SimpleNamespace(
        revision=0,
        _feeds=feeds,
        _callbacks=[],
        _spinner=SimpleNamespace(executor=executor),
        _subscribe=nothing,
    )
    node = NodeToken(domain=0, zid="a", nid=1, namespace="/", node="talker")
    tokens: list[Token] = [*map(endpoint_token, ("/b", "/c", "/d")), node]
    for token in tokens:
        System._on_token(system, token, True)
    assert tasks == [feeds["/b"]]
    assert [feed.questions for feed in feeds.values()] == [0, 1, 0]
    assert system.revision == 4


def test_one_thread_at_a_time_asks_for_the_definition_of_a_topic() -> None:
    runs: list[Callable[[], None]] = []

    def interface(name: str) -> None:
        raise UnknownTypeError(name)

    system: Any = SimpleNamespace(
        context=SimpleNamespace(start_thread=lambda _name, run: runs.append(run)),
        interface=interface,
    )
    feed: Any = SimpleNamespace(type_name="a/msg/B", learned_type=None, problem="")
    for _ in range(3):
        System._learn(system, feed)
    assert len(runs) == 1
    runs[0]()
    assert "no definition of a/msg/B" in feed.problem
    System._learn(system, feed)
    assert len(runs) == 2
