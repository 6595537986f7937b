"""Checks of all panels with axe: names for screen readers, headings, contrast of colours."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

import pytest

import zbot

pytest.importorskip("nicegui", reason="NiceGUI is not installed")
pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")
pytest.importorskip("axe_playwright_python", reason="axe is not installed")

from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import expect

from zbot.web.panels import PANELS

from std_msgs.msg import String

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.web.conftest import Server, Visit

#: Quasar shows a bar without a name while a file is loaded, also the file with axe.
_WITHOUT_BAR = {"exclude": [["#q-loading-bar"]]}


#: Themes by the width of the window. The colours do not depend on the width.
_THEMES: dict[int, tuple[Literal["light", "dark"], ...]] = {
    390: ("light",),
    1024: ("light", "dark"),
    1920: ("light",),
}


#: Several tests, so that several workers share the panels.
_PARTS = 4


@pytest.mark.usefixtures("turtlesim")
@pytest.mark.parametrize("part", range(_PARTS))
def test_axe_finds_nothing_in_any_panel(
    visit: Callable[..., Visit], server: Server, make_context: Callable[[], zbot.Context], part: int
) -> None:
    node = zbot.Node("talker", context=make_context())
    node.create_publisher(String, "chatter", 10)
    node.get_logger().info("Hello")
    page = visit().page
    found = []
    for panel in PANELS[part::_PARTS]:
        page.goto(f"{server.address}{panel.path}")
        expect(page.locator(".zb-command")).not_to_be_empty()
        for width, themes in _THEMES.items():
            page.set_viewport_size({"width": width, "height": 844})
            for theme in themes:
                page.emulate_media(color_scheme=theme)
                found += [
                    (
                        panel.path,
                        width,
                        theme,
                        fault["id"],
                        [node["html"] for node in fault["nodes"]],
                    )
                    for fault in Axe().run(page, _WITHOUT_BAR).response["violations"]
                ]
    assert not found, "\n".join(map(str, found))
