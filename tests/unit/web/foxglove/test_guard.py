"""Tests of the guard in front of the server for Foxglove."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from zbot.web.foxglove.guard import Guard

if TYPE_CHECKING:
    from zbot.web.foxglove.publishing import Publishing

INNER = ("127.1.2.3", 1)


def no_client() -> Publishing:
    raise NotImplementedError


def request(host: str, origin: str = "", target: str = "/", upgrade: str = "websocket") -> bytes:
    lines = [f"GET {target} HTTP/1.1", f"Host: {host}", f"Upgrade: {upgrade}"]
    if origin:
        lines.append(f"Origin: {origin}")
    return ("\r\n".join(lines) + "\r\n\r\n").encode()


@pytest.mark.parametrize(
    ("head", "reason"),
    [
        (request("127.0.0.1:8765"), ""),
        (request("localhost:8765", "https://app.foxglove.dev"), ""),
        (request("localhost:8765", "file://"), ""),
        (request("localhost:8765", "http://localhost:8080"), ""),
        (request("localhost:8765", "http://lab:8080"), ""),
        (request("localhost:8765", "http://127.0.0.1.evil.example"), "may not connect"),
        (request("localhost:8765", "https://evil.example"), "may not connect: allow them with"),
        (request("localhost:8765", "null"), "may not connect"),
        (request("evil.example:8765"), "is not a name of this server"),
        (request("10.0.0.7:8765"), "is not a name of this server"),
        (request("[broken"), "is not a name of this server"),
        (request("localhost", upgrade="h2c"), "open this address in Foxglove"),
        (b"POST / HTTP/1.1\r\nHost: localhost\r\n\r\n", "open this address in Foxglove"),
        (b"\r\n\r\n", "the first line is not that of a request"),
        (request("localhost\r\nHost: evil.example"), "the field host comes twice"),
        (request("localhost", "file://\r\nOrigin: null"), "the field origin comes twice"),
    ],
)
def test_websites_and_other_names_are_refused_on_loopback(head: bytes, reason: str) -> None:
    guard = Guard("127.0.0.1", INNER, None, ["http://lab:8080"], publishing=no_client)
    assert reason in guard.refusal(head)
    assert bool(reason) == bool(guard.refusal(head))


@pytest.mark.parametrize(
    ("head", "reason"),
    [
        (request("10.0.0.7:8765", target="/?token=secret"), ""),
        (request("10.0.0.7:8765"), "the token is missing"),
        (request("10.0.0.7:8765", target="/?token=wrong"), "the token is missing"),
        (request("evil.example", target="/?token=secret"), "is not a name"),
        (request("10.0.0.7", "https://evil.example", "/?token=secret"), "may not connect"),
    ],
)
def test_a_wider_address_needs_the_token(head: bytes, reason: str) -> None:
    guard = Guard("0.0.0.0", INNER, "secret", publishing=no_client)
    assert reason in guard.refusal(head)
    assert bool(reason) == bool(guard.refusal(head))


def test_extensions_are_left_out_because_the_guard_reads_the_messages() -> None:
    head = (
        b"GET /?token=secret HTTP/1.1\r\nHost: a\r\n"
        b"sec-websocket-extensions: permessage-deflate; client_max_window_bits\r\nA: b\r\n\r\n"
    )
    expected = b"GET / HTTP/1.1\r\nHost: a\r\nA: b\r\n\r\n"
    assert Guard.without_token(head) == expected
