"""Plain Zenoh sessions around a hub, and checks of which messages pass between them."""

from __future__ import annotations

import contextlib
import json
import random
import socket
from functools import partial
from typing import TYPE_CHECKING, Any

import zenoh

from tests.conftest import allowed, wait_until

if TYPE_CHECKING:
    from collections.abc import Mapping

HERE = "127.0.0.1"
PING = "@class/teacher/ping"
_QUIET = {
    "scouting/multicast/enabled": False,
    "scouting/delay": 1,
    "adminspace/enabled": True,
    "timestamping/enabled": True,
}


def free_port() -> int:
    """Return a port that nobody uses, below those that systems give to connections meanwhile."""
    while True:
        port = random.randrange(10_000, 32_000)
        with contextlib.suppress(OSError), socket.create_server((HERE, port)):
            return port


def open_session(paths: Mapping[str, Any]) -> zenoh.Session:
    """Open a session with some of Zenoh's configuration paths set."""
    config = zenoh.Config()
    for path, value in {**_QUIET, **paths}.items():
        config.insert_json5(path, json.dumps(value))
    return zenoh.open(config)


def dialling(port: int, paths: Mapping[str, Any] | None = None) -> dict[str, Any]:
    """Return the configuration of a client that fails if the hub rejects it."""
    return {
        "mode": "client",
        "connect/endpoints": [f"tcp/{HERE}:{port}"],
        "connect/timeout_ms": round(1000 * allowed(3.0)),
        "connect/exit_on_failure": True,
        **(paths or {}),
    }


def accepts(port: int, paths: Mapping[str, Any]) -> bool:
    """Return whether a hub accepts a client that dials it once."""
    try:
        session = open_session({**dialling(port), "connect/timeout_ms": 0, **paths})
    except zenoh.ZError:
        return False
    session.close()
    return True


def answers(session: zenoh.Session, key: str) -> bool:
    """Return whether anybody answers a query."""
    return any(reply.ok for reply in session.get(key, timeout=allowed(1.0)))


class Talk:
    """Sessions that are linked through one that may speak to all of them.

    Args:
        middle: That one: of the hub itself, or of the teacher.
    """

    def __init__(self, middle: zenoh.Session) -> None:
        self._middle = middle
        self._members: list[tuple[zenoh.Session, str]] = []
        middle.declare_queryable(PING, lambda query: query.reply(PING, b""), complete=True)

    def add(self, session: zenoh.Session, domain: int) -> zenoh.Session:
        """Let a session take part in `settle`; it has to be at home in a domain."""
        key = f"{domain}/ping/{session.info.zid()}"
        session.declare_queryable(key, lambda query: query.reply(key, b""), complete=True)
        self._members.append((session, key))
        return session

    def remove(self, session: zenoh.Session) -> None:
        """Let a session go its way."""
        self._members = [(member, key) for member, key in self._members if member is not session]

    def settle(self) -> None:
        """Let everything sent so far arrive: a question and its answer overtake nothing."""
        for session, _ in self._members:
            assert wait_until(partial(answers, session, PING))
        for _, key in self._members:
            assert wait_until(partial(answers, self._middle, key))

    def hears(self, listener: zenoh.Session, speaker: zenoh.Session, key: str) -> bool:
        """Return whether what one session publishes reaches the other."""
        subscriber = listener.declare_subscriber(key, zenoh.handlers.FifoChannel(10))
        self.settle()
        speaker.put(key, b"x")
        self.settle()
        sample = subscriber.try_recv()
        subscriber.undeclare()
        return sample is not None

    def sees(self, watcher: zenoh.Session, declarer: zenoh.Session, key: str) -> bool:
        """Return whether a token that one session declares is seen by the other."""
        token = declarer.liveliness().declare_token(key)
        self.settle()
        found = any(reply.ok for reply in watcher.liveliness().get(key, timeout=allowed(1.0)))
        token.undeclare()
        return found

    def reaches(self, client: zenoh.Session, server: zenoh.Session, key: str) -> bool:
        """Return whether a service that one session offers answers the other."""
        queryable = server.declare_queryable(key, lambda query: query.reply(key, b"mine"))
        self.settle()
        replies = client.get(key, target=zenoh.QueryTarget.ALL, timeout=allowed(1.0))
        found = any(reply.ok and reply.ok.payload.to_bytes() == b"mine" for reply in replies)
        queryable.undeclare()
        return found
