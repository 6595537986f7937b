"""Fixtures of the tests of bundled nodes: a node under test, and a node that watches it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import MakeContext, Spin


class Bench:
    """Place where a node is tried: it runs nodes, and sees what they publish."""

    def __init__(self, make_context: MakeContext, spin: Spin) -> None:
        self.context = make_context()
        self._spin = spin
        self.watcher = zbot.Node("watcher", context=self.context)
        spin(self.watcher)

    def run(
        self, make: Callable[..., zbot.Node], parameters: dict[str, Any] | None = None
    ) -> zbot.Node:
        """Start a node with parameters, and spin it."""
        overrides = [
            zbot.Parameter(name, value=parameter) for name, parameter in (parameters or {}).items()
        ]
        node = make(context=self.context, parameter_overrides=overrides)
        self._spin(node)
        return node

    def watch(self, type_: type[Any], topic: str, qos: Any = 10) -> list[Any]:
        """Return a list that fills with the messages of a topic."""
        messages: list[Any] = []
        self.watcher.create_subscription(type_, topic, messages.append, qos)
        return messages

    def publisher(self, type_: type[Any], topic: str, qos: Any = 10) -> zbot.Publisher[Any]:
        """Return a publisher that a node under test listens to."""
        publisher: zbot.Publisher[Any] = self.watcher.create_publisher(type_, topic, qos)
        assert wait_until(lambda: publisher.get_subscription_count() > 0, 10), topic
        return publisher

    def stamp(self) -> Any:
        """Return the present time as a message."""
        return self.watcher.get_clock().now().to_msg()

    def call(self, type_: type[Any], service: str, request: Any) -> Any:
        """Call a service, and return its response."""
        client: Any = self.watcher.create_client(type_, service)
        assert client.wait_for_service(10)
        future = client.call_async(request)
        assert wait_until(future.done, 10), service
        return future.result()


@pytest.fixture
def bench(make_context: MakeContext, spin: Spin) -> Bench:
    """Return a bench for one node under test."""
    return Bench(make_context, spin)


def arrives(condition: Callable[[], object]) -> bool:
    """Wait until a condition holds."""
    return wait_until(lambda: bool(condition()), 10)
