"""Which replies a server keeps for requests that come again."""

from __future__ import annotations

from typing import Any

import pytest

from zbot.memory import LARGE_BYTES
from zbot.node.service_request import RepeatedRequests

ANA, BEN = bytes(16), bytes(15) + b"b"


class Server:
    """Serves requests, whose queries are texts here."""

    def __init__(self) -> None:
        self.repeated = RepeatedRequests()
        self.replied: list[Any] = []

    def serve(
        self, number: int, client: bytes, query: Any, *, size: int = 10, is_late: bool = False
    ) -> bool:
        """Return whether the callback ran."""
        request = number.to_bytes(8, "little") + client
        if not self.repeated.is_new(request, query, arrived_s=0.0 if is_late else float("inf")):
            return False
        reply = self.replied.append
        reply(self.repeated.end(request, query, reply, size))
        return True


@pytest.fixture
def server() -> Server:
    return Server()


def test_the_latest_request_of_each_client_is_served_once(server: Server) -> None:
    assert server.serve(1, ANA, "a")
    assert server.serve(1, BEN, "b")
    assert not server.serve(1, ANA, "a again")
    assert not server.serve(1, BEN, "b again")
    assert server.serve(2, ANA, "c")
    assert server.replied == ["a", "b", "a again", "b again", "c"]


def test_a_quick_reply_is_kept_until_the_next_one(server: Server) -> None:
    assert server.serve(1, ANA, "a")
    assert server.serve(2, ANA, "b")
    assert server.serve(1, ANA, "a")


def test_a_large_reply_is_not_kept(server: Server) -> None:
    assert server.serve(1, ANA, "a", size=LARGE_BYTES)
    assert server.serve(1, ANA, "a", size=LARGE_BYTES)


def test_replies_of_32_clients_are_kept(server: Server) -> None:
    clients = [bytes([number]) * 16 for number in range(33)]
    assert all(server.serve(1, client, "a") for client in clients)
    assert not any(server.serve(1, client, "again") for client in clients[1:])
    assert server.serve(1, clients[0], "a")


def test_a_client_that_calls_often_is_not_the_first_to_be_forgotten(server: Server) -> None:
    assert server.serve(1, ANA, "a")
    others = [bytes([number]) * 16 for number in range(1, 33)]
    assert all(server.serve(1, client, "b") for client in others[:31])
    assert server.serve(2, ANA, "c")
    assert server.serve(1, others[31], "d")
    assert not server.serve(2, ANA, "c again")


def test_late_replies_are_kept_up_to_a_size(server: Server) -> None:
    for number in range(5):
        assert server.serve(number, ANA, "a", size=10_000_000, is_late=True)
    assert not server.serve(4, ANA, "again", is_late=True)
    assert not server.serve(2, ANA, "again", is_late=True)
    assert server.serve(1, ANA, "again", is_late=True)
    assert server.serve(7, BEN, "a", size=10**9, is_late=True)
    assert not server.serve(7, BEN, "again", is_late=True)
