from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

import pytest

from zbot.observer.errors import ViewerError
from zbot.observer.serving.address import ROSBRIDGE_PATHS, address, is_loopback, origin_of
from zbot.web.server.request_check import RequestCheck

if TYPE_CHECKING:
    from collections.abc import MutableMapping

PORT = 8080


async def application(_scope: Any, _receive: Any, send: Any) -> None:
    await send({"type": "http.response.start", "status": 200, "headers": []})
    await send({"type": "http.response.body", "body": b"page"})


def ask(guard: RequestCheck, path: str = "/", kind: str = "http", **headers: str) -> Any:
    """Return the first message of the response to a request, with its headers as a dictionary."""
    sent: list[MutableMapping[str, Any]] = []
    scheme = headers.pop("scheme", "http")
    path, _, query = path.partition("?")
    named = {"host": f"127.0.0.1:{PORT}"} | {
        name.replace("_", "-"): value for name, value in headers.items()
    }
    scope = {
        "type": kind,
        "scheme": scheme,
        "path": path,
        "query_string": query.encode(),
        "server": ("127.0.0.1", PORT),
        "headers": [(name.encode(), value.encode()) for name, value in named.items()],
    }

    async def send(message: MutableMapping[str, Any]) -> None:
        sent.append(message)

    async def receive() -> MutableMapping[str, Any]:
        return {"type": "http.request"}

    asyncio.run(guard(scope, receive, send))
    first = dict(sent[0])
    first["headers"] = {name.decode(): value.decode() for name, value in first.get("headers", ())}
    return first


def local() -> RequestCheck:
    return RequestCheck(application, host="127.0.0.1", token=None)


def with_errors_shown() -> RequestCheck:
    return RequestCheck(application, host="0.0.0.0", token="secret")


@pytest.mark.parametrize(
    ("headers", "status"),
    [
        ({}, 200),
        ({"host": "localhost:8080"}, 200),
        ({"host": "LOCALHOST:8080"}, 200),
        ({"host": "[::1]:8080"}, 200),
        ({"host": "rebound.example:8080"}, 403),
        ({"host": "192.168.1.7:8080"}, 403),
        ({"host": ""}, 403),
        ({"host": "127.0.0.1:8080; script-src *"}, 403),
        ({"host": "user@127.0.0.1:8080"}, 403),
        ({"host": "127.0.0.1.evil.example"}, 403),
        ({"origin": "http://127.0.0.1:8080"}, 200),
        ({"origin": "http://127.0.0.1:9090"}, 403),
        ({"origin": "http://evil.example"}, 403),
        ({"origin": "null"}, 403),
        ({"origin": "http://["}, 400),
        ({"origin": "http://[::1"}, 400),
        ({"sec_fetch_site": "same-origin"}, 200),
        ({"sec_fetch_site": "cross-site", "sec_fetch_dest": "document"}, 200),
        ({"sec_fetch_site": "cross-site", "sec_fetch_dest": "iframe"}, 403),
        ({"sec_fetch_site": "cross-site", "sec_fetch_dest": "image"}, 403),
        ({"sec_fetch_site": "same-site", "sec_fetch_dest": "empty"}, 403),
    ],
)
def test_only_pages_of_this_server_are_answered(headers: dict[str, str], status: int) -> None:
    assert ask(local(), **headers)["status"] == status


@pytest.mark.parametrize("origin", ["http://evil.example", "null", "http://127.0.0.1:1"])
def test_websocket_of_another_site_is_closed(origin: str) -> None:
    closed = ask(local(), kind="websocket", origin=origin)
    assert (closed["type"], closed["code"]) == ("websocket.close", 1008)


def test_token_in_the_address_becomes_a_cookie() -> None:
    guard = with_errors_shown()
    assert ask(guard)["status"] == 403
    assert ask(guard, "/?token=wrong")["status"] == 403
    answer = ask(guard, "/plot?token=secret&curve=%2Fpose.x")
    assert answer["status"] == 303
    assert answer["headers"]["location"] == "/plot?curve=%2Fpose.x"
    cookie = answer["headers"]["set-cookie"]
    assert "HttpOnly" in cookie
    pair = cookie.partition(";")[0]
    assert ask(guard, "/plot", cookie=f"other=1; {pair}")["status"] == 200
    assert ask(guard, "/plot", cookie=f"{pair}x")["status"] == 403


def test_websocket_needs_the_cookie() -> None:
    guard = with_errors_shown()
    assert ask(guard, kind="websocket")["type"] == "websocket.close"
    assert ask(guard, "/?token=secret", kind="websocket")["type"] == "websocket.close"
    cookie = f"zbot_{PORT}=secret"
    assert ask(guard, kind="websocket", cookie=cookie)["type"] == "http.response.start"


OPEN, CLOSED = "http.response.start", "websocket.close"


def test_pages_of_a_guest_reach_only_rosbridge() -> None:
    guest = "http://localhost:8000"
    guard = RequestCheck(application, host="127.0.0.1", token=None, guests=[guest])
    for path in ROSBRIDGE_PATHS:
        assert ask(guard, path, "websocket", origin=guest)["type"] == OPEN
        assert ask(guard, path, "websocket", origin="http://evil.example")["type"] == CLOSED
        assert ask(guard, path, "websocket", origin="null")["type"] == CLOSED
        assert ask(guard, path, "websocket", origin=guest, host="evil.example")["type"] == CLOSED
        assert ask(local(), path, "websocket", origin=guest)["type"] == CLOSED
    assert ask(guard, "/_nicegui_ws/", "websocket", origin=guest)["type"] == CLOSED
    assert ask(guard, "/", origin=guest)["status"] == 403


def test_programs_without_cookies_use_rosbridge_with_the_token() -> None:
    guard = RequestCheck(application, host="0.0.0.0", token="secret", guests=[])
    assert ask(guard, "/?token=secret", "websocket")["type"] == OPEN
    assert ask(guard, "/rosbridge?token=secret", "websocket")["type"] == OPEN
    assert ask(guard, "/?token=wrong", "websocket")["type"] == CLOSED
    assert ask(guard, "/_nicegui_ws/?token=secret", "websocket")["type"] == CLOSED
    origin = "http://evil.example"
    assert ask(guard, "/?token=secret", "websocket", origin=origin)["type"] == CLOSED


def test_token_does_not_redirect_to_another_server() -> None:
    answer = ask(with_errors_shown(), "//evil.example/?token=secret")
    assert answer["headers"]["location"] == "/evil.example/"
    # Browsers read a backslash as a slash, and leave out a tab.
    answer = ask(with_errors_shown(), "/\\evil.example/?token=secret")
    assert answer["headers"]["location"] == "/%5Cevil.example/"
    answer = ask(with_errors_shown(), "/\t/evil.example/?token=secret")
    assert answer["headers"]["location"] == "/%09/evil.example/"


def test_header_of_proxies_does_not_reach_the_application() -> None:
    reached: list[bytes] = []

    async def headers_of(scope: Any, _receive: Any, send: Any) -> None:
        reached.extend(name for name, _ in scope["headers"])
        await application(scope, _receive, send)

    guard = RequestCheck(headers_of, host="127.0.0.1", token=None)
    assert ask(guard, x_forwarded_prefix="/evil", accept="x")["status"] == 200
    assert reached == [b"host", b"accept"]


def test_with_a_token_all_ip_addresses_are_accepted_but_no_foreign_name() -> None:
    cookie = f"zbot_{PORT}=secret"
    assert ask(with_errors_shown(), host="192.168.1.7:8080", cookie=cookie)["status"] == 200
    assert ask(with_errors_shown(), host="rebound.example:8080", cookie=cookie)["status"] == 403


@pytest.mark.parametrize("host", ["classroom-pc", "classroom-pc.local"])
def test_own_names_are_accepted_only_by_a_server_for_other_machines(
    monkeypatch: pytest.MonkeyPatch, host: str
) -> None:
    monkeypatch.setattr("socket.gethostname", lambda: "classroom-pc")
    assert ask(local(), host=f"{host}:8080")["status"] == 403
    cookie = f"zbot_{PORT}=secret"
    assert ask(with_errors_shown(), host=f"{host}:8080", cookie=cookie)["status"] == 200


def test_responses_have_a_content_security_policy() -> None:
    policy = ask(local())["headers"]["content-security-policy"]
    assert "default-src 'self'" in policy
    assert "frame-ancestors 'self'" in policy
    assert "ws://127.0.0.1:8080" in policy


@pytest.mark.parametrize(
    ("host", "expected"),
    [
        ("127.0.0.1", True),
        ("127.1.2.3", True),
        ("::1", True),
        ("localhost", True),
        ("0.0.0.0", False),
        ("192.168.1.7", False),
        ("teacher.local", False),
    ],
)
def test_is_loopback(host: str, expected: bool) -> None:
    assert is_loopback(host) is expected


def test_address_is_a_url() -> None:
    assert address("127.0.0.1", 8080, "/", None) == "http://127.0.0.1:8080/"
    assert address("::1", 80, "/plot", "a b") == "http://[::1]:80/plot?token=a+b"
    assert address("::1", 80, "/", None, scheme="ws") == "ws://[::1]:80/"


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ("http://localhost:8000", "http://localhost:8000"),
        ("http://LocalHost:8000/my/page.html?a=1", "http://localhost:8000"),
        ("https://example.org:443/", "https://example.org"),
        ("http://[::1]:8000", "http://[::1]:8000"),
    ],
)
def test_origin_of_a_page(given: str, expected: str) -> None:
    assert origin_of(given) == expected


@pytest.mark.parametrize(
    "given",
    ["null", "", "*", "localhost:8000", "file:///a.html", "http://", "http://a:b", "ws://a"],
)
def test_other_texts_have_no_origin(given: str) -> None:
    with pytest.raises(ViewerError, match="not the address of a page"):
        origin_of(given)


@pytest.mark.parametrize(
    ("host", "frames"),
    [
        ("127.0.0.1:8080", "http://127.0.0.1:*"),
        ("localhost", "http://localhost:*"),
        ("[::1]:8080", "http://[::1]:*"),
    ],
)
def test_frames_show_only_pages_of_this_machine(host: str, frames: str) -> None:
    policy = ask(local(), host=host)["headers"]["content-security-policy"]
    assert f"frame-src 'self' {frames};" in policy


@pytest.mark.parametrize(
    ("scheme", "kind", "origin", "is_answered"),
    [
        ("https", "http", "https://127.0.0.1:8080", True),
        ("wss", "websocket", "https://127.0.0.1:8080", True),
        ("https", "http", "http://127.0.0.1:8080", False),  # anybody in the network may change it
        ("wss", "websocket", "http://127.0.0.1:8080", False),
        ("wss", "websocket", "https://evil.example", False),
        ("https", "http", "https://evil.example", False),
    ],
)
def test_with_https_only_pages_with_https_are_answered(
    scheme: str, kind: str, origin: str, is_answered: bool
) -> None:
    first = ask(local(), kind=kind, scheme=scheme, origin=origin)
    refused = {"http.response.start", "websocket.close"}
    assert (first.get("status") == 200 or first["type"] not in refused) == is_answered


def test_the_cookie_of_a_page_with_https_is_never_sent_without_it() -> None:
    for scheme, is_secure in (("https", True), ("http", False)):
        first = ask(with_errors_shown(), "/?token=secret", scheme=scheme)
        assert ("; secure" in first["headers"]["set-cookie"].lower()) == is_secure
