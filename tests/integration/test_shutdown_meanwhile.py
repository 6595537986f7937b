"""Tests of calls during which another thread shuts the context down."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from zbot.action import ActionClient, ActionServer
from zbot.errors import NotInitializedError
from zbot.transport.program_file import ProgramFile

from example_interfaces.action import Fibonacci
from std_msgs.msg import String
from std_srvs.srv import Trigger

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path


def then(context: zbot.Context, function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function that shuts the context down before the given function runs."""

    def ended(*arguments: Any, **options: Any) -> Any:
        context.shutdown()
        return function(*arguments, **options)

    return ended


@pytest.mark.parametrize(
    "create",
    [
        lambda node: zbot.Node("other", context=node.context),
        lambda node: node.create_publisher(String, "topic", 1),
        lambda node: node.create_subscription(String, "topic", print, 1),
        lambda node: node.create_client(Trigger, "service"),
        lambda node: node.create_service(Trigger, "service", lambda _, response: response),
        lambda node: ActionClient(node, Fibonacci, "action"),
        lambda node: ActionServer(node, Fibonacci, "action", lambda _: Fibonacci.Result()),
    ],
    ids=["node", "publisher", "subscription", "client", "service", "action client", "action"],
)
def test_nothing_is_created_in_a_closed_session(
    talker: zbot.Node, create: Callable[[zbot.Node], object], monkeypatch: pytest.MonkeyPatch
) -> None:
    graph = talker.context.graph
    monkeypatch.setattr(graph, "announce", then(talker.context, graph.announce))
    with pytest.raises(NotInitializedError, match=r"needs \w+.init\(\) first"):
        create(talker)


@pytest.mark.parametrize("moment", ["_settle", "watch"])
def test_a_query_of_the_graph_returns_what_is_known(
    talker: zbot.Node, moment: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    graph = talker.context.graph
    monkeypatch.setattr(graph, moment, then(talker.context, getattr(graph, moment)))
    assert talker.get_node_names() == ["talker"]
    assert not talker.wait_for_node("/other", timeout=3600)


def test_a_wait_for_a_service_ends(talker: zbot.Node, monkeypatch: pytest.MonkeyPatch) -> None:
    client = talker.create_client(Trigger, "service")
    context = talker.context
    monkeypatch.setattr(context, "receiver", then(context, context.receiver))
    assert not client.wait_for_service()


@pytest.mark.parametrize("method", ["call", "call_async"])
def test_a_service_call_is_refused(
    talker: zbot.Node, method: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    client = talker.create_client(Trigger, "service")
    talker.create_service(Trigger, "service", lambda _, response: response)
    session = talker.context.session

    class ClosedSession:
        get = staticmethod(then(talker.context, session.get))

    monkeypatch.setattr(zbot.Context, "session", ClosedSession)
    with pytest.raises(NotInitializedError, match="a service call needs"):
        getattr(client, method)(Trigger.Request())


def test_a_program_file_may_be_closed_while_it_is_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = ProgramFile(tmp_path)

    def close_and_dump(_: object) -> str:
        file.close()
        return "{}"

    monkeypatch.setattr("zbot.transport.program_file.json.dumps", close_and_dump)
    file.write({})
    file.write({})
    assert not list(tmp_path.iterdir())
