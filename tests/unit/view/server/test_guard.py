"""The guard passes on what its own page sends, and refuses everything else."""

from __future__ import annotations

import asyncio
from concurrent.futures import Future
from typing import Any

import pytest

from zbot.observer.serving.request import Request, parsed
from zbot.view.server.guard import Guard, passed_on, with_policy
from zbot.view.server.software_webgl import with_script

PORT = 8090
OWN = f"127.0.0.1:{PORT}"
WEBSOCKET = {"upgrade": "websocket"}


def request(host: str = OWN, target: str = "/", method: str = "GET", **fields: str) -> Request:
    named = {name.replace("_", "-"): value for name, value in fields.items()}
    return Request(method, target, {"host": host, **named})


def refusal(guard: Guard, asked: Request) -> str:
    answer = guard.answer(asked)
    return "" if answer is None else answer.text


@pytest.mark.parametrize(
    ("asked", "reason"),
    [
        (request(), ""),
        (request(f"localhost:{PORT}"), ""),
        (request(origin=f"http://{OWN}", **WEBSOCKET), ""),
        (request(sec_fetch_site="same-origin"), ""),
        (request(sec_fetch_site="cross-site", sec_fetch_dest="document"), ""),
        (request("evil.example:8090"), "is not a name of this server"),
        (request("10.0.0.7:8090"), "is not a name of this server"),
        (request("127.0.0.1.evil.example"), "is not a name of this server"),
        (request("[broken"), "is not a name of this server"),
        (request(""), "is not a name of this server"),
        (request(origin="http://127.0.0.1:1234", **WEBSOCKET), "may not send requests"),
        (request(origin="https://evil.example", **WEBSOCKET), "may not send requests"),
        (request(origin="null", **WEBSOCKET), "may not send requests"),
        (request(origin="http://[", **WEBSOCKET), "may not send requests"),
        (request(sec_fetch_site="cross-site", sec_fetch_dest="image"), "pages of other sites"),
        (request(sec_fetch_site="cross-site", sec_fetch_dest="iframe"), "pages of other sites"),
        (request(sec_fetch_site="same-site", **WEBSOCKET), "pages of other sites"),
        (request(method="POST"), "requests with POST are not possible"),
    ],
)
def test_other_sites_are_refused_on_loopback(asked: Request, reason: str) -> None:
    found = refusal(Guard("127.0.0.1", PORT, None), asked)
    assert reason in found
    assert bool(reason) == bool(found)


def test_other_machines_need_the_token() -> None:
    guard = Guard("0.0.0.0", PORT, "secret")
    own = "192.168.1.5:8090"
    assert "the token is missing" in refusal(guard, request(own))
    assert "the token is missing" in refusal(guard, request(own, "/?token=guess"))
    assert "the token is missing" in refusal(guard, request(own, cookie="zbot_view_1=secret"))
    # A websocket cannot be redirected, so it needs the cookie.
    asked = request(own, "/?token=secret", **WEBSOCKET)
    assert "the token is missing" in refusal(guard, asked)
    assert guard.answer(request(own, cookie="other=1; zbot_view_8090=secret")) is None


def test_the_token_is_replaced_by_a_cookie() -> None:
    guard = Guard("0.0.0.0", PORT, "secret")
    answer = guard.answer(request("192.168.1.5:8090", "//evil.example/?a=1&token=secret"))
    assert answer is not None
    assert answer.status == 303
    fields = dict(answer.fields)
    assert fields["Location"] == "/evil.example/?a=1"
    assert fields["Set-Cookie"] == "zbot_view_8090=secret; HttpOnly; Path=/; SameSite=Lax"


def test_the_server_behind_gets_one_request_without_secrets() -> None:
    asked = parsed(
        b"GET /a?token=secret&b=c HTTP/1.1\r\nHost: a:1\r\nCookie: zbot_view_1=secret\r\n"
        b"Connection: keep-alive\r\nContent-Length: 5\r\n\r\n"
    )
    assert passed_on(asked) == b"GET /a?b=c HTTP/1.1\r\nhost: a:1\r\nconnection: close\r\n\r\n"


def test_the_server_behind_neither_compresses_its_page_nor_leaves_it_out() -> None:
    asked = request(accept_encoding="gzip", if_none_match="1", if_modified_since="today")
    assert b"gzip" not in passed_on(asked)
    assert b"if-" not in passed_on(asked)


def test_the_page_gets_a_script_for_browsers_without_a_graphics_card() -> None:
    head = b"HTTP/1.1 200 OK\r\nContent-Type: text/html\r\nContent-Length: 13\r\n\r\n"
    changed, body = with_script(head, b"<head></head>")
    assert body.startswith(b"<head><script>")
    assert body.endswith(b"</script></head>")
    assert b"Content-Length: %d\r\n" % len(body) in changed


def test_other_answers_get_no_script() -> None:
    head = b"HTTP/1.1 200 OK\r\nContent-Type: image/png\r\nContent-Length: 6\r\n\r\n"
    assert with_script(head, b"<head>") == (head, b"<head>")


def test_the_browser_gets_a_policy() -> None:
    head = with_policy(b"HTTP/1.1 200 OK\r\nContent-Length: 1\r\n\r\n", "a:1", "'none'")
    assert head.startswith(b"HTTP/1.1 200 OK\r\nContent-Length: 1\r\nContent-Security-Policy: ")
    assert b"connect-src 'self' data: blob: ws://a:1 wss://a:1;" in head
    assert b"frame-ancestors 'none'\r\n" in head
    assert head.endswith(b"\r\n\r\n")


@pytest.mark.parametrize(
    ("site", "dest", "page_port", "is_answered"),
    [
        ("same-site", "iframe", 8080, True),
        ("same-site", "iframe", None, False),
        ("same-site", "empty", 8080, False),
        ("cross-site", "iframe", 8080, False),
    ],
)
def test_only_a_page_of_this_machine_has_the_view_in_a_frame(
    site: str, dest: str, page_port: int | None, is_answered: bool
) -> None:
    guard = Guard("127.0.0.1", PORT, "secret", page_port)
    fields = {"sec_fetch_site": site, "sec_fetch_dest": dest, "cookie": "zbot_view_8090=secret"}
    assert (guard.answer(request(**fields)) is None) == is_answered


@pytest.mark.parametrize(
    ("host", "page"),
    [
        ("127.0.0.1:8090", "http://127.0.0.1:8080"),
        ("localhost:8090", "http://localhost:8080"),
        ("[::1]:8090", "http://[::1]:8080"),
    ],
)
def test_the_policy_names_the_page_that_has_the_view_in_a_frame(host: str, page: str) -> None:
    guard = Guard("127.0.0.1", PORT, "secret", 8080)
    behind: list[bytes] = []
    asked = f"GET / HTTP/1.1\r\nHost: {host}\r\nCookie: zbot_view_8090=secret\r\n\r\n"
    answer = asyncio.run(_answers(asked.encode(), behind, guard))
    assert f"frame-ancestors {page}\r\n".encode() in answer
    assert b"secret" not in behind[0]


async def _answers(sent: bytes, behind: list[bytes], guard: Guard | None = None) -> bytes:
    """Return what a client gets from a guard in front of a server that answers each request."""

    async def inner(reader: Any, writer: Any) -> None:
        behind.append(await reader.readuntil(b"\r\n\r\n"))
        writer.write(b"HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\nok")
        writer.close()

    server = await asyncio.start_server(inner, "127.0.0.1", 0)
    guard = guard or Guard("127.0.0.1", PORT, None)
    guard.inner = server.sockets[0].getsockname()
    front = await asyncio.start_server(guard.serve, "127.0.0.1", 0)
    reader, writer = await asyncio.open_connection(*front.sockets[0].getsockname())
    writer.write(sent)
    answer = await reader.read()
    writer.close()
    front.close()
    server.close()
    return answer


def test_a_second_request_in_the_same_connection_is_not_passed_on() -> None:
    first = f"GET / HTTP/1.1\r\nHost: {OWN}\r\n\r\n".encode()
    second = b"GET /secret HTTP/1.1\r\nHost: evil.example\r\n\r\n"
    behind: list[bytes] = []
    answer = asyncio.run(_answers(first + second, behind))
    assert answer.endswith(b"ok")
    assert len(behind) == 1


def test_a_refused_request_does_not_reach_the_server_behind() -> None:
    behind: list[bytes] = []
    sent = b"GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n"
    answer = asyncio.run(_answers(sent, behind))
    assert answer.startswith(b"HTTP/1.1 403 Forbidden\r\n")
    assert behind == []


def _guard_with_file(asked: list[str]) -> Guard:
    def rviz_file() -> Future[str]:
        asked.append("")
        found: Future[str] = Future()
        found.set_result("Panels: []\n")
        return found

    guard = Guard("127.0.0.1", PORT, "secret")
    guard.rviz_file = rviz_file
    return guard


def test_the_displays_are_a_download() -> None:
    asked: list[str] = []
    sent = f"GET /view.rviz HTTP/1.1\r\nHost: {OWN}\r\nCookie: zbot_view_8090=secret\r\n\r\n"
    behind: list[bytes] = []
    answer = asyncio.run(_answers(sent.encode(), behind, _guard_with_file(asked)))
    assert answer.startswith(b"HTTP/1.1 200 OK\r\n")
    assert b'Content-Disposition: attachment; filename="view.rviz"\r\n' in answer
    assert answer.endswith(b"\r\n\r\nPanels: []\n")
    assert (len(asked), behind) == (1, [])


def test_an_arrangement_that_cannot_be_written_is_told_at_once() -> None:
    failed: Future[str] = Future()
    failed.set_exception(KeyError("defect"))
    guard = Guard("127.0.0.1", PORT, "secret")
    guard.rviz_file = lambda: failed
    sent = f"GET /view.rviz HTTP/1.1\r\nHost: {OWN}\r\nCookie: zbot_view_8090=secret\r\n\r\n"
    answer = asyncio.run(_answers(sent.encode(), [], guard))
    assert answer.startswith(b"HTTP/1.1 503 ")
    assert b"could not write this arrangement" in answer


@pytest.mark.parametrize(
    "fields",
    [
        f"Host: {OWN}",
        f"Host: {OWN}\r\nCookie: zbot_view_8090=guess",
        "Host: evil.example\r\nCookie: zbot_view_8090=secret",
        f"Host: {OWN}\r\nCookie: zbot_view_8090=secret\r\nOrigin: http://evil.example",
        f"Host: {OWN}\r\nCookie: zbot_view_8090=secret\r\nSec-Fetch-Site: cross-site",
    ],
)
def test_the_displays_are_no_download_for_others(fields: str) -> None:
    asked: list[str] = []
    sent = f"GET /view.rviz HTTP/1.1\r\n{fields}\r\n\r\n"
    answer = asyncio.run(_answers(sent.encode(), [], _guard_with_file(asked)))
    assert answer.startswith(b"HTTP/1.1 403 Forbidden\r\n")
    assert asked == []


def test_the_arrangement_of_a_link_is_opened() -> None:
    guard = Guard("127.0.0.1", 8090, None)
    opened: list[str] = []
    guard.open_link = opened.append
    for target in ("/?arrangement=abc", "/", "/?arrangement="):
        guard._open(request(target=target))
    guard._open(request(target="/?arrangement=x", **WEBSOCKET))
    assert opened == ["abc"]
