from __future__ import annotations

import urllib.error
import urllib.request
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from playwright.sync_api import Page

    from tests.web.conftest import Server


def status(address: str, **headers: str) -> int:
    named = {name.replace("_", "-"): value for name, value in headers.items()}
    try:
        with urllib.request.urlopen(urllib.request.Request(address, headers=named)) as response:
            return int(response.status)
    except urllib.error.HTTPError as error:
        error.close()
        return error.code


def test_page_names_its_panel(server: Server, page: Page) -> None:
    page.goto(f"{server.address}/topics")
    page.wait_for_selector(".zb-title:has-text('Topics')")
    assert page.title() == "Topics - zbot"


@pytest.mark.parametrize(
    "headers",
    [
        {"Host": "rebound.example"},
        {"Origin": "http://evil.example"},
        {"Origin": "null"},
        {"Sec_Fetch_Site": "cross-site", "Sec_Fetch_Dest": "image"},
    ],
)
def test_requests_of_other_sites_are_refused(server: Server, headers: dict[str, str]) -> None:
    assert status(server.address) == 200
    assert status(server.address, **headers) == 403


def test_ctrl_c_ends_it_quietly(server: Server, page: Page) -> None:
    page.goto(server.address)
    page.wait_for_selector(".zb-title")
    assert server.stop() == 130
    assert server.program.output.count("\n") == 0
