"""Channels of the server for Foxglove: a channel for each topic, with its schema."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

from zbot.bag.definition import ENCODING, definition_text
from zbot.errors import NotInitializedError, ZbotError
from zbot.log import get_logger
from zbot.names import is_hidden
from zbot.remote.profiles import profile_to_show

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot
    from zbot.node.subscription import Subscription
    from zbot.observer.system import System
    from zbot.web.foxglove.type_search import TypeSearch

_DEPTH = 100


class _Topic:
    """Topic that clients can subscribe to."""

    def __init__(self, channel: Any, type_name: str) -> None:
        self.channel = channel
        self.type_name = type_name
        self.clients: set[int] = set()
        self.subscription: Subscription[Any] | None = None


class Channels:
    """Channels of all topics. The server subscribes to a topic while a client shows the topic.

    Args:
        system: The running system.
        context: The SDK's context, to which the server belongs.
        types: The search for the types of topics.
    """

    def __init__(self, system: System, context: Any, types: TypeSearch) -> None:
        self._system = system
        self._context = context
        self._types = types
        self._lock = threading.RLock()
        self._topics: dict[str, _Topic] = {}
        self._unknown: dict[str, str] = {}  #: types that are not found, by topic

    def update(self, graph: Snapshot) -> None:
        """Offer the topics of a graph.

        This call may ask other machines for types, which takes a while.
        """
        found = {name: types[0] for name, types in graph.topics() if not is_hidden(name)}
        with self._lock:
            gone = [
                name for name, topic in self._topics.items() if found.get(name) != topic.type_name
            ]
        for name in gone:
            self._remove(name)
        self._unknown = {name: kind for name, kind in self._unknown.items() if name in found}
        for name, type_name in found.items():
            if name not in self._topics:
                self._add(name, type_name)

    def subscribe(self, topic: str, client: int) -> None:
        """Note that a client shows a topic."""
        with self._lock:
            shown = self._topics.get(topic)
            if shown is None:
                return
            shown.clients.add(client)
            if shown.subscription is None:
                shown.subscription = self._subscription(topic, shown)

    def unsubscribe(self, topic: str, client: int) -> None:
        """Note that a client does not show a topic any more."""
        with self._lock:
            shown = self._topics.get(topic)
            if shown is None:
                return
            shown.clients.discard(client)
            if not shown.clients:
                self._end(shown)

    def _add(self, name: str, type_name: str) -> None:
        from foxglove import Channel, Schema  # noqa: PLC0415 - an extra

        try:
            self._types.find(type_name)
            text = definition_text(type_name)
        except ZbotError as error:
            if self._unknown.get(name) != type_name:  # the warning comes once
                self._unknown[name] = type_name
                get_logger("zbot.foxglove").warning(f"{name} is not shown: {error}")
            return
        self._unknown.pop(name, None)
        schema = Schema(name=type_name, encoding=ENCODING, data=text.encode())
        channel = Channel(name, schema=schema, message_encoding="cdr", context=self._context)
        with self._lock:
            self._topics[name] = _Topic(channel, type_name)

    def _remove(self, name: str) -> None:
        with self._lock:
            shown = self._topics.pop(name)
            self._end(shown)
        shown.channel.close()

    def _subscription(self, topic: str, shown: _Topic) -> Subscription[Any] | None:
        publishers = self._system.snapshot().publishers(topic)
        profile = profile_to_show([end.qos for end in publishers], _DEPTH)

        def send(data: bytes) -> None:
            shown.channel.log(data)

        try:
            return self._system.node.create_subscription(
                self._system.interface(shown.type_name), topic, send, profile, raw=True
            )
        except NotInitializedError:
            return None  # the program ends

    def _end(self, shown: _Topic) -> None:
        subscription, shown.subscription = shown.subscription, None
        if subscription is not None and self._system.context.ok():
            self._system.node.destroy_subscription(subscription)
