"""Tests of the listener that tells browsers to use https."""

from __future__ import annotations

import errno
import queue
import socket
import time
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

from zbot.web.server import https_listener
from zbot.web.server.https_listener import HttpsListener

if TYPE_CHECKING:
    from collections.abc import Iterator

PATIENCE_S = 10


class Listening:
    """Listener on a free port, and the connections that it accepted."""

    def __init__(self) -> None:
        self.socket = socket.create_server(("127.0.0.1", 0))
        self.accepted: queue.Queue[socket.socket] = queue.Queue()
        self.listener = HttpsListener(self.socket, self.accepted.put)

    def connect(self, data: bytes = b"") -> socket.socket:
        made = socket.create_connection(self.socket.getsockname(), timeout=PATIENCE_S)
        made.sendall(data)
        return made

    def close(self) -> None:
        self.listener.close()
        self.socket.close()
        while not self.accepted.empty():
            self.accepted.get().close()


@pytest.fixture
def listening() -> Iterator[Listening]:
    made = Listening()
    yield made
    made.close()


def test_a_connection_with_tls_is_accepted_with_all_of_its_bytes(listening: Listening) -> None:
    with listening.connect(b"\x16\x03\x01"):
        accepted = listening.accepted.get(timeout=PATIENCE_S)
        assert accepted.recv(10) == b"\x16\x03\x01"
        accepted.close()


def test_a_request_without_tls_is_told_to_use_https(listening: Listening) -> None:
    with listening.connect(b"GET /?token=a HTTP/1.1\r\nHost: evil.example\r\n\r\n") as browser:
        answer = browser.makefile("rb").read()
    assert answer.startswith(b"HTTP/1.1 400 Bad Request\r\n")
    assert b"write https:// in place of http://" in answer
    assert b"evil.example" not in answer
    assert listening.accepted.empty()


def test_silent_connections_do_not_hold_up_others(listening: Listening) -> None:
    silent = [listening.connect() for _ in range(20)]
    with listening.connect(b"\x16"):
        listening.accepted.get(timeout=PATIENCE_S).close()
    silent[0].sendall(b"\x16")
    listening.accepted.get(timeout=PATIENCE_S).close()
    for one in silent:
        one.close()


def test_of_too_many_silent_connections_the_oldest_ends(
    listening: Listening, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(https_listener, "_MOST_SILENT", 2)
    silent = [listening.connect() for _ in range(3)]
    assert silent[0].recv(1) == b""
    silent[2].sendall(b"\x16")
    listening.accepted.get(timeout=PATIENCE_S).close()
    for one in silent:
        one.close()


class FullSocket(socket.socket):
    """Listening socket that cannot accept its first connection: too many files are open."""

    is_full = True

    def accept(self) -> tuple[socket.socket, Any]:
        if self.is_full:
            self.is_full = False
            raise OSError(errno.EMFILE, "Too many open files")
        return super().accept()


def test_a_process_with_too_many_open_files_waits(monkeypatch: pytest.MonkeyPatch) -> None:
    pauses: list[float] = []
    clock = SimpleNamespace(sleep=pauses.append, monotonic=time.monotonic)
    monkeypatch.setattr(https_listener, "time", clock)
    accepted: queue.Queue[socket.socket] = queue.Queue()
    with FullSocket() as full:
        full.bind(("127.0.0.1", 0))
        full.listen()
        listener = HttpsListener(full, accepted.put)
        with socket.create_connection(full.getsockname(), timeout=PATIENCE_S) as browser:
            browser.sendall(b"\x16")
            accepted.get(timeout=PATIENCE_S).close()
        listener.close()
    assert pauses == [0.1]


def test_a_closed_listener_closes_what_it_holds() -> None:
    listening = Listening()
    with listening.connect() as silent:
        listening.close()
        listening.listener.close()
        assert silent.recv(1) == b""
