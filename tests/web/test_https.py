"""Tests of the page with https, in a real browser and with Python's own TLS."""

from __future__ import annotations

import http.client
import os
import ssl
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import urlsplit

import pytest

import zbot
from tests.conftest import wait_until
from tests.web.test_security import ATTACK, another_site, unsafe_page
from tests.web.test_sensors_panel import PHONE, READINGS, emulated, switch
from zbot.classroom.hub.address import own_addresses

from sensor_msgs.msg import Imu

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

if TYPE_CHECKING:
    from collections.abc import Callable

    from playwright.sync_api import Browser

    from tests.conftest import MakeContext, Spin
    from tests.web.conftest import Server, Visit


@pytest.fixture
def https_server(serve: Callable[..., Server]) -> Server:
    return serve("--https")


def bare(server: Server) -> str:
    """Return the address of this machine, without the token."""
    return f"https://127.0.0.1:{urlsplit(server.address).port}"


def query(server: Server) -> str:
    return urlsplit(server.address).query


def test_a_phone_publishes_its_motion_over_https(
    visit: Callable[..., Visit],
    https_server: Server,
    make_context: MakeContext,
    spin: Spin,
) -> None:
    node = zbot.Node("listener", context=make_context())
    messages: list[Imu] = []
    node.create_subscription(Imu, "/phone/imu", messages.append, 10)
    spin(node)
    phone = {"viewport": PHONE, "is_mobile": True, "has_touch": True, "user_agent": "Mobile"}
    page = visit(ignore_https_errors=True, **phone).page
    with emulated(page, READINGS):
        page.goto(f"{bare(https_server)}/sensors?{query(https_server)}")
        assert page.evaluate("isSecureContext")
        assert page.evaluate("window.socket.io.uri").startswith("wss://")
        switch(page, "Orientation and acceleration").tap()
        assert wait_until(lambda: bool(messages))
    (cookie,) = page.context.cookies()
    assert cookie.get("secure")
    assert cookie.get("httpOnly")


def test_the_code_for_a_phone_is_shown_on_this_machine(
    visit: Callable[..., Visit], https_server: Server, server: Server
) -> None:
    if not own_addresses():
        pytest.skip("this machine has no address in a network")
    page = visit(ignore_https_errors=True).page
    page.goto(f"{bare(https_server)}/sensors?{query(https_server)}")
    expect(page.get_by_alt_text("QR code of the address for a phone")).to_be_visible()
    expect(page.get_by_text(f"https://{own_addresses()[0]}:")).to_contain_text("/sensors?token=")
    page.goto(f"{server.address}/sensors")
    expect(page.get_by_text("start `zbot web --https sensors`")).to_be_visible()


def test_the_certificate_is_that_of_the_machines_own_authority(https_server: Server) -> None:
    folder = Path(os.environ["XDG_CONFIG_HOME"]) / "zbot" / "page-certificate"
    context = ssl.create_default_context(cafile=str(folder / "public" / "ca.cert.pem"))
    port = urlsplit(https_server.address).port
    for host in ["127.0.0.1", "localhost", *own_addresses()]:
        connection = http.client.HTTPSConnection(host, port, context=context, timeout=20)
        connection.request("GET", "/sensors")
        assert connection.getresponse().status == 403  # the token is missing
        connection.close()
    shown = ssl.get_server_certificate(("127.0.0.1", port or 0))
    printed = https_server.program.wait_for("certificate: SHA-256 ").partition("SHA-256 ")[2]
    assert fingerprint_of(shown) == printed.strip()
    with pytest.raises(ssl.SSLCertVerificationError):
        http.client.HTTPSConnection(
            "127.0.0.1", port, context=ssl.create_default_context(), timeout=20
        ).request("GET", "/")


def fingerprint_of(certificate: str) -> str:
    import hashlib  # noqa: PLC0415 - only here

    digest = hashlib.sha256(ssl.PEM_cert_to_DER_cert(certificate)).hexdigest().upper()
    return ":".join(digest[at : at + 2] for at in range(0, len(digest), 2))


def test_a_browser_without_https_is_told_to_use_it(browser: Browser, https_server: Server) -> None:
    with unsafe_page(browser) as page:
        answer = page.goto(bare(https_server).replace("https", "http"))
        assert answer is not None
        assert answer.status == 400
        assert "write https:// in place of http://" in page.inner_text("body")


def test_a_page_of_another_site_reaches_nothing_over_https(
    browser: Browser, https_server: Server
) -> None:
    address = bare(https_server)
    with another_site() as evil, unsafe_page(browser, ignore_https_errors=True) as page:
        page.goto(f"{address}/topics?{query(https_server)}")  # the browser has the cookie
        page.wait_for_selector(".zb-list")
        for host in ("localhost", "127.0.0.1"):
            page.goto(evil.replace("localhost", host))
            assert page.evaluate(ATTACK, address) == ["refused"] * 4


def test_without_https_the_page_says_why_a_phone_refuses(
    visit: Callable[..., Visit], serve: Callable[..., Server]
) -> None:
    if not own_addresses():
        pytest.skip("this machine has no address in a network")
    window = visit()
    page = window.page
    page.goto(serve("--host", "0.0.0.0").address.replace("/?", "/sensors?"))
    expect(page.locator(".zb-warn").filter(has_text="zbot web --https")).to_be_visible()
    switch(page, "Camera").click()
    expect(page.get_by_role("status").filter(has_text="zbot web --https")).to_be_visible()
    expect(switch(page, "Camera")).not_to_be_checked()
    window.requests.clear()  # the address in the network is this machine's
