"""Clients of `zbot foxglove` and rosbridge that want too much, beside a client that does not."""

from __future__ import annotations

import contextlib
import json
import queue
import socket
import struct
import sys
import threading
import time
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar
from urllib.parse import urlsplit

import pytest

pytest.importorskip("websockets", reason="websockets is not installed")

from websockets.exceptions import ConnectionClosed, InvalidHandshake
from websockets.sync.client import connect

import zbot
from tests.conftest import allowed, wait_until
from tests.torture.client_attacks import CLIENTS
from zbot.observer.serving.client_budget import (
    MAX_CLIENTS,
    MAX_MESSAGE_BYTES,
    MAX_PUBLISHED,
    MAX_SUBSCRIBED,
    MESSAGES_PER_S,
)

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Program, Start

STRING, TRANSFORMS = "std_msgs/msg/String", "tf2_msgs/msg/TFMessage"


class _Client:
    """Client that notes what it is told, and how often."""

    options: ClassVar[dict[str, Any]] = {}

    def __init__(self, address: str) -> None:
        self.told: list[str] = []
        self.messages: queue.Queue[Any] = queue.Queue()
        self.counts = Counter[str]()
        options: Any = {"max_size": None, "open_timeout": allowed(20), **self.options}
        self.socket = connect(address, compression=None, **options)
        self._thread = threading.Thread(target=self._read, daemon=True)
        self._thread.start()

    def _read(self) -> None:
        with contextlib.suppress(ConnectionClosed):
            for message in self.socket:
                self._note(message)

    def _note(self, message: str | bytes) -> None:
        if isinstance(message, bytes):
            self.messages.put(message)
            return
        fields = json.loads(message)
        self.counts[fields["op"]] += 1
        if fields["op"] == "status":
            self.told.append(fields.get("message") or fields["msg"])
        else:
            self.messages.put(fields)

    def send(self, **fields: Any) -> None:
        self.socket.send(json.dumps(fields))

    def was_told(self, text: str) -> bool:
        return wait_until(lambda: any(text in said for said in self.told), allowed(20))

    def close(self) -> None:
        self.socket.close()
        self._thread.join(allowed(10))

    def __enter__(self) -> Any:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


class FoxgloveClient(_Client):
    options: ClassVar = {"subprotocols": ["foxglove.sdk.v1"]}

    def advertise(self, *topics: str, type_name: str = STRING) -> None:
        channels = [
            {"id": number, "topic": topic, "encoding": "json", "schemaName": type_name}
            for number, topic in enumerate(topics)
        ]
        for start in range(0, len(channels), 1000):
            self.send(op="advertise", channels=channels[start : start + 1000])

    def publish(self, _topic: str, message: str) -> None:
        self.socket.send(struct.pack("<BI", 1, 0) + message.encode())

    def subscribe(self, count: int) -> None:
        subscriptions = [{"id": number, "channelId": number} for number in range(count)]
        self.send(op="subscribe", subscriptions=subscriptions)


class RosbridgeClient(_Client):
    def advertise(self, *topics: str, type_name: str = STRING) -> None:
        for topic in topics:
            self.send(op="advertise", topic=topic, type=type_name)

    def publish(self, topic: str, message: str) -> None:
        self.socket.send(f'{{"op":"publish","topic":"{topic}","msg":{message}}}')

    def subscribe(self, count: int) -> None:
        for number in range(count):
            self.send(op="subscribe", topic=f"/topic{number}", type=STRING)


class Server:
    """Running server, whose clients are of one kind."""

    def __init__(self, start: Start, kind: str) -> None:
        if kind == "foxglove":
            pytest.importorskip("foxglove", reason="foxglove-sdk is not installed")
            program, sign = start("zbot", "foxglove", "--port", "0"), "zbot foxglove: "
        else:
            pytest.importorskip("nicegui", reason="NiceGUI is not installed")
            arguments = ("--no-browser", "--port", "0", "--rosbridge")
            program, sign = start("zbot", "web", *arguments), "rosbridge: "
        self.kind = kind
        self.program: Program = program
        self.address = program.wait_for(sign, 30).partition(sign)[2]

    def client(self) -> Any:
        return (FoxgloveClient if self.kind == "foxglove" else RosbridgeClient)(self.address)

    @property
    def memory_mb(self) -> float:
        """The largest memory so far."""
        text = Path(f"/proc/{self.program.process.pid}/status").read_text()
        return int(text.partition("VmHWM:")[2].split()[0]) / 1000


@pytest.fixture(params=["foxglove", "rosbridge"])
def server(start: Start, request: pytest.FixtureRequest) -> Server:
    return Server(start, request.param)


@pytest.fixture
def watcher(make_context: MakeContext) -> zbot.Node:
    return zbot.Node("watcher", context=make_context())


def publishers(watcher: zbot.Node) -> int:
    """Return how many topics of the attack have a publisher."""
    names = dict(watcher.get_topic_names_and_types())
    return sum(name.startswith("/attack") for name in names)


def works(client: Any, watcher: zbot.Node) -> bool:
    """Return whether a client can publish."""
    client.advertise("/honest")
    return wait_until(lambda: watcher.count_publishers("/honest") == 1, allowed(5))


def test_a_client_that_advertises_without_end_is_told_and_leaves_nothing(
    server: Server, watcher: zbot.Node
) -> None:
    greedy = server.client()
    greedy.advertise(*(f"/attack{number}" for number in range(MAX_PUBLISHED + 20)))
    assert greedy.was_told(f"a client can publish on {MAX_PUBLISHED} topics")
    with server.client() as honest:
        assert works(honest, watcher)
        assert wait_until(lambda: publishers(watcher) == MAX_PUBLISHED)
        greedy.close()
        assert wait_until(lambda: publishers(watcher) == 0, allowed(3))


# Not rosbridge, which needs 14 s for the subscriptions. Its limit is in rosbridge/test_limits.py.
@pytest.mark.parametrize("server", ["foxglove"], indirect=True)
def test_a_client_that_subscribes_without_end_is_told(server: Server, watcher: zbot.Node) -> None:
    with server.client() as greedy, server.client() as honest:
        greedy.subscribe(MAX_SUBSCRIBED + 20)
        assert greedy.was_told(f"a client can subscribe to {MAX_SUBSCRIBED} topics")
        assert works(honest, watcher)


@pytest.mark.skipif(sys.platform != "linux", reason="the memory of a process is read from /proc")
def test_a_message_that_would_fill_the_memory_is_refused(
    server: Server, watcher: zbot.Node
) -> None:
    with server.client() as greedy, server.client() as honest:
        greedy.advertise("/attack", type_name=TRANSFORMS)
        assert wait_until(lambda: publishers(watcher) == 1)
        before_mb = server.memory_mb
        bomb = '{"transforms":[' + "{}," * 1_000_000 + "{}]}"
        greedy.publish("/attack", bomb)
        assert greedy.was_told("more than 200000 objects")
        assert works(honest, watcher)
        greedy.publish("/attack", '{"transforms":[' + "{}," * 100_000 + "{}]}")
        assert greedy.was_told("the messages in transforms leave out too many values")
        assert server.memory_mb - before_mb < 100


@pytest.mark.skipif(sys.platform != "linux", reason="the memory of a process is read from /proc")
def test_what_waits_for_a_client_that_does_not_read_is_bounded(
    server: Server, watcher: zbot.Node
) -> None:
    silent = CLIENTS[server.kind](server.address)
    silent.advertise("/attack")
    silent.subscribe("/attack")
    message = silent.publication("/attack", json.dumps({"data": "x" * 1_000_000}))
    with contextlib.closing(silent.socket), server.client() as honest:
        silent.socket.send(message)
        before_mb = server.memory_mb
        for _ in range(150):
            silent.socket.send(message)
        assert works(honest, watcher)
        assert server.memory_mb - before_mb < 90


def test_messages_above_the_rate_are_refused_by_name(server: Server, watcher: zbot.Node) -> None:
    with server.client() as greedy, server.client() as honest:
        greedy.advertise("/attack")
        assert wait_until(lambda: publishers(watcher) == 1)
        # A slow machine reads only a little faster than the limit, so it takes many messages.
        for number in range(30 * MESSAGES_PER_S):
            if number % 100 == 0 and greedy.told:
                break
            greedy.publish("/attack", '{"data":"x"}')
        assert greedy.was_told(f"you send more than {MESSAGES_PER_S} messages a second")
        assert works(honest, watcher)


def test_a_message_above_the_limit_ends_only_its_client(server: Server, watcher: zbot.Node) -> None:
    greedy = server.client()
    with server.client() as honest:
        with contextlib.suppress(ConnectionClosed, OSError):
            greedy.publish("/attack", '{"data":"' + "x" * (MAX_MESSAGE_BYTES + 100) + '"}')
        greedy._thread.join(allowed(20))
        assert not greedy._thread.is_alive()
        assert works(honest, watcher)
    greedy.close()


def test_clients_beyond_the_limit_are_refused(server: Server, watcher: zbot.Node) -> None:
    with contextlib.ExitStack() as ends:
        honest = ends.enter_context(server.client())
        for _ in range(MAX_CLIENTS - 1):
            ends.enter_context(server.client())
        with contextlib.suppress(InvalidHandshake, ConnectionClosed):
            with server.client() as late:
                late._thread.join(allowed(10))
                late.socket.recv()
            pytest.fail("a client too many was accepted")
        assert works(honest, watcher)


def test_connections_that_send_nothing_keep_nobody_away(server: Server, watcher: zbot.Node) -> None:
    parts = urlsplit(server.address)
    with contextlib.ExitStack() as ends:
        target = (str(parts.hostname), int(parts.port or 0))
        silent = [
            ends.enter_context(socket.create_connection(target, allowed(10))) for _ in range(300)
        ]
        began_s = time.monotonic()
        with server.client() as honest:
            assert works(honest, watcher)
        assert time.monotonic() - began_s < allowed(5)
        assert wait_until(lambda: _is_closed(silent[0]))  # for the newer ones


def _is_closed(connection: socket.socket) -> bool:
    connection.settimeout(0.1)
    try:
        return connection.recv(1) == b""
    except ConnectionResetError:
        return True
    except TimeoutError:
        return False
