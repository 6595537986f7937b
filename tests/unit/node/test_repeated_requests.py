"""Which replies a server keeps for requests that come again."""

from __future__ import annotations

from typing import Any

import pytest

from zbot.node.service_request import RepeatedRequests

ANA, BEN = bytes(16), bytes(15) + b"b"


class Server:
    """Serves requests, whose queries are texts here."""

    def __init__(self) -> None:
        self.repeated = RepeatedRequests()
        self.replied: list[Any] = []

    def serve(self, number: int, client: bytes, query: Any, *, is_large: bool = False) -> bool:
        """Return whether the callback ran."""
        request = number.to_bytes(8, "little") + client
        if not self.repeated.is_new(request, query, arrived_s=float("inf")):
            return False
        reply = self.replied.append
        reply(self.repeated.end(request, query, reply, is_large=is_large))
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
    assert server.serve(1, ANA, "a", is_large=True)
    assert server.serve(1, ANA, "a", is_large=True)


def test_replies_of_32_clients_are_kept(server: Server) -> None:
    clients = [bytes([number]) * 16 for number in range(33)]
    assert all(server.serve(1, client, "a") for client in clients)
    assert not any(server.serve(1, client, "again") for client in clients[1:])
    assert server.serve(1, clients[0], "a")
