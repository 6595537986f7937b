"""Clients of `zbot foxglove` and rosbridge that want too much, beside an honest client.

`python -m tests.torture.client_attacks --seconds 600` attacks each server in each way for ten
minutes. The honest client sends a message about every 10 ms, and waits until it has come back. Its
times and the server's memory are printed: before an attack, during it, and a minute after it.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import signal
import struct
import sys
import tempfile
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

from tests.conftest import wait_until
from tests.torture.processes import Process, Processes, clean_end, memory_mb
from tests.torture.report import Report, percentile
from tests.torture.stall import StallMeter
from zbot.testing.domain import reserved_domain

if TYPE_CHECKING:
    from collections.abc import Callable

    from websockets.sync.client import ClientConnection

_STRING, _TRANSFORMS = "std_msgs/msg/String", "tf2_msgs/msg/TFMessage"
_PERIOD_S = 0.01
MOST_TIMES = 2.0  #: the honest client's 99th percentile under an attack, compared with before
LEAST_MS = 20.0  #: shorter times are not compared: other work of the machine takes as long
MOST_MEMORY = 1.5
MOST_BACK = 1.4  #: a minute after the attack; buffers of the first large message stay
BACK_S = 60.0
_MODULE = "tests.torture.client_attacks"
_SERVERS = {
    "foxglove": ("zbot", "foxglove", "--port", "0"),
    "rosbridge": ("zbot", "web", "--no-browser", "--port", "0", "--rosbridge"),
}
_SIGNS = {"foxglove": "zbot foxglove: ", "rosbridge": "rosbridge: "}


class Foxglove:
    """Client of `zbot foxglove`."""

    def __init__(self, address: str) -> None:
        self.socket = _connect(address, subprotocols=["foxglove.sdk.v1"])
        self._channels: dict[str, int] = {}

    def advertise(self, *topics: str, type_name: str = _STRING, first: int = 0) -> None:
        channels = [
            {"id": number, "topic": topic, "encoding": "json", "schemaName": type_name}
            for number, topic in enumerate(topics, first)
        ]
        self.socket.send(json.dumps({"op": "advertise", "channels": channels}))

    @staticmethod
    def publication(_topic: str, message: str) -> bytes:
        return struct.pack("<BI", 1, 0) + message.encode()

    def subscribe(self, topic: str) -> None:
        while topic not in self._channels:
            message = self.socket.recv(20)
            if isinstance(message, str):
                for channel in json.loads(message).get("channels", ()):
                    self._channels[channel["topic"]] = channel["id"]
        wanted = {"id": 0, "channelId": self._channels[topic]}
        self.socket.send(json.dumps({"op": "subscribe", "subscriptions": [wanted]}))

    @staticmethod
    def is_message(message: str | bytes) -> bool:
        return isinstance(message, bytes) and message[:1] == b"\x01"

    def ask_for_all(self) -> str:
        return json.dumps({"op": "getParameters", "parameterNames": [], "id": "all"})


class Rosbridge:
    """Client of rosbridge."""

    def __init__(self, address: str) -> None:
        self.socket = _connect(address)

    def advertise(self, *topics: str, type_name: str = _STRING, first: int = 0) -> None:
        del first  # topics have no numbers
        for topic in topics:
            self.socket.send(json.dumps({"op": "advertise", "topic": topic, "type": type_name}))

    @staticmethod
    def publication(topic: str, message: str) -> str:
        return f'{{"op":"publish","topic":"{topic}","msg":{message}}}'

    def subscribe(self, topic: str) -> None:
        self.socket.send(json.dumps({"op": "subscribe", "topic": topic}))

    @staticmethod
    def is_message(message: str | bytes) -> bool:
        return isinstance(message, str) and '"publish"' in message[:200]

    def ask_for_all(self) -> str:
        return json.dumps({"op": "call_service", "service": "/rosapi/get_param_names"})


CLIENTS: dict[str, type[Foxglove] | type[Rosbridge]] = {
    "foxglove": Foxglove,
    "rosbridge": Rosbridge,
}


def _connect(address: str, **options: Any) -> ClientConnection:
    # Without pings: a server that lets a client wait does not answer them in time.
    limits: dict[str, Any] = {"max_size": None, "open_timeout": 20, "ping_interval": None}
    return connect(address, compression=None, **limits, **options)


def _topics(client: Any) -> None:
    for first in range(0, 20_000, 500):
        client.advertise(*(f"/attack{first + n}" for n in range(500)), first=first)
    _read_all(client.socket)


def _large(client: Any) -> None:
    _flood(client, '{"transforms":[' + "{}," * 999_999 + "{}]}", pause_s=0.5)


def _empty(client: Any) -> None:
    _flood(client, '{"transforms":[' + "{}," * 14_999 + "{}]}", pause_s=0)


def _some(client: Any) -> None:
    _flood(client, '{"transforms":[' + "{}," * 1_499 + "{}]}", pause_s=0)


def _rate(client: Any) -> None:
    _flood(client, '{"transforms":[]}', pause_s=0.0001)


def _slow(client: Any) -> None:
    client.advertise("/attack")
    client.subscribe("/attack")
    message = client.publication("/attack", json.dumps({"data": "x" * 1_000_000}))
    while True:
        client.socket.send(message)
        time.sleep(0.05)


def _parameters(client: Any) -> None:
    while True:
        for _ in range(100):
            client.socket.send(client.ask_for_all())
        time.sleep(0.05)


def _flood(client: Any, message: str, pause_s: float) -> None:
    client.advertise("/attack", type_name=_TRANSFORMS)
    publication = client.publication("/attack", message)
    while True:
        client.socket.send(publication)
        if pause_s:
            time.sleep(pause_s)


def _read_all(socket: ClientConnection) -> None:
    for _ in socket:
        pass


ATTACKS: dict[str, Callable[[Any], None]] = {
    "20,000 topics to publish on": _topics,
    "messages of 3 MB with a million empty transforms": _large,
    "messages with 15,000 empty transforms": _empty,
    "messages with 1,500 empty transforms": _some,
    "10,000 messages a second": _rate,
    "a client that does not read 20 messages of 1 MB a second": _slow,
    "2,000 requests a second for all parameters": _parameters,
}


class Honest:
    """Client that measures how long its messages take."""

    def __init__(self, client: Any) -> None:
        self._client = client
        client.advertise("/honest")
        client.subscribe("/honest")
        self._publication = client.publication("/honest", '{"data":"x"}')
        self._begin()
        self.measure(1.0)

    def _begin(self) -> None:
        """Send until the subscription has begun, and then read what is left."""
        while True:
            self._client.socket.send(self._publication)
            with contextlib.suppress(TimeoutError):
                while not self._client.is_message(self._client.socket.recv(0.5)):
                    pass
                break
        with contextlib.suppress(TimeoutError):
            while True:
                self._client.socket.recv(0.5)

    def measure(self, seconds: float) -> list[float]:
        """Return the times of its messages, in milliseconds."""
        found = []
        end_s = time.monotonic() + seconds
        while time.monotonic() < end_s:
            began_s = time.monotonic()
            self._client.socket.send(self._publication)
            while not self._client.is_message(self._client.socket.recv(60)):
                pass
            took_s = time.monotonic() - began_s
            found.append(1000 * took_s)
            time.sleep(max(0.0, _PERIOD_S - took_s))
        return found


class Campaign:
    """Attacks of one server after the other."""

    def __init__(self, processes: Processes, report: Report, seconds: float) -> None:
        self._processes, self._report, self._seconds = processes, report, seconds

    def attack(self, kind: str, name: str) -> None:
        """Attack a new server, and check its figures."""
        server = self._processes.start(kind, *_SERVERS[kind])
        sign = _SIGNS[kind]
        wait_until(lambda: sign in server.text(), 30)
        address = server.text().partition(sign)[2].split()[0]
        honest = Honest(CLIENTS[kind](address))
        alone = percentile(honest.measure(min(60.0, max(5.0, self._seconds / 4))), 0.99)
        start_mb = memory_mb(server.pid)
        words = ("--attacker", name, "--server", kind, "--address", address)
        attacker = self._processes.start("attacker", sys.executable, "-m", _MODULE, *words)
        times, most_mb = self._during(honest, server)
        attacker.signal(signal.SIGKILL)
        attacker.wait(5)
        wait_until(lambda: memory_mb(server.pid) < MOST_BACK * start_mb, BACK_S)
        back_mb = memory_mb(server.pid)
        under, median = percentile(times, 0.99), percentile(times, 0.5)
        title = f"{kind}, {name}"
        self._report.note(
            f"{title}: {alone:.0f} ms, then {under:.0f} ms (median {median:.0f} ms); "
            f"{start_mb:.0f} MB, at most {most_mb:.0f} MB, then {back_mb:.0f} MB"
        )
        for line in attacker.text().splitlines()[-1:]:
            self._report.violation(f"{title}: the attacker's last line is {line[:120]}")
        self._report.limit(title, under, max(MOST_TIMES * alone, LEAST_MS), "ms")
        self._report.limit(title, most_mb, MOST_MEMORY * start_mb, "MB")
        self._report.limit(title, back_mb, MOST_BACK * start_mb, "MB a minute later")
        server.signal(signal.SIGINT)
        server.wait(10)

    def _during(self, honest: Honest, server: Process) -> tuple[list[float], float]:
        times: list[float] = []
        most_mb = 0.0
        end_s = time.monotonic() + self._seconds
        while time.monotonic() < end_s:
            times += honest.measure(0.25)
            most_mb = max(most_mb, memory_mb(server.pid))
        return times, most_mb


def main() -> int:
    parser = argparse.ArgumentParser(description="Attack servers, beside an honest client.")
    parser.add_argument("--seconds", type=float, default=600, help="time of each attack")
    parser.add_argument("--server", choices=list(_SERVERS), help="only this server")
    parser.add_argument("--only", action="append", help="only attacks whose name has this text")
    parser.add_argument("--attacker", help=argparse.SUPPRESS)
    parser.add_argument("--address", help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.attacker:
        while True:
            with contextlib.suppress(ConnectionClosed, OSError):  # it connects again
                ATTACKS[given.attacker](CLIENTS[given.server](given.address))
            time.sleep(_PERIOD_S)
    folder = Path(tempfile.mkdtemp(prefix="zbot-attacks-"))
    report = Report()
    with (
        clean_end(),
        reserved_domain() as domain,
        StallMeter() as stall,
        Processes(folder, domain) as processes,
    ):
        campaign = Campaign(processes, report, given.seconds)
        with report.until_interrupted():
            for kind in _SERVERS:
                for name in ATTACKS:
                    is_chosen = not given.only or any(text in name for text in given.only)
                    if is_chosen and given.server in {None, kind}:
                        campaign.attack(kind, name)
    return report.end(f"python -m {_MODULE} --seconds {given.seconds:g}", folder, stall)


if __name__ == "__main__":
    sys.exit(main())
