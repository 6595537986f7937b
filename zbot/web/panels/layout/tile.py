"""Tile of a layout, which shows a panel in a frame."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

from nicegui import ui

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from zbot.web.page.panel import Panel


class Tile:
    """Frame with a panel, and the buttons above it.

    The panel is a page of its own in the frame, so it keeps its state when other tiles change.

    Args:
        key: The key of the tile, which JavaScript reports with each change of the panel's address.
        panel: The panel.
        address: The address of the panel, e.g. `plot?curve=/pose.x`.
        actions: The functions of the menu, by name.
    """

    def __init__(
        self, key: str, panel: Panel, address: str, actions: Mapping[str, Callable[[], object]]
    ) -> None:
        self.key, self.address = key, address
        name = f"{panel.title} {key}"
        self.element = ui.element("section").classes("zb-card zb-tile")
        self.element.props["aria-label"] = name
        with self.element:
            with ui.element("div").classes("zb-tile-head"):
                ui.icon(panel.icon).classes("zb-link-icon")
                ui.label(panel.title).classes("zb-tile-title zb-grow")
                self._link = _icon_link("open_in_new", f"Open {name} alone", f"/{address}")
                _menu(name, actions)
            frame: Any = ui.element("iframe")
            frame.props["title"] = name
            frame.props["data-tile"] = key
            frame.props["src"] = f"/{address}"

    def set_address(self, address: str) -> None:
        """Note the address that the panel has now. The frame is not loaded again."""
        self.address = address
        self._link.props["href"] = f"/{address}"
        self._link.update()


def _icon_link(icon: str, name: str, address: str) -> ui.element:
    link = ui.element("a").classes("zb-tile-link").props("target=_blank")
    link.props["href"] = address
    link.props["aria-label"] = link.props["title"] = name
    with link:
        ui.icon(icon)
    return link


def _menu(name: str, actions: Mapping[str, Callable[[], object]]) -> None:
    chosen: list[Callable[[], object]] = []

    def act() -> None:
        while chosen:
            chosen.pop()()

    button = ui.button(icon="more_vert").props("flat round dense size=sm")
    button.props["aria-label"] = f"Arrange {name}"
    with button, ui.menu().props("auto-close") as menu:
        for text, action in actions.items():
            ui.menu_item(text, on_click=partial(chosen.append, action)).props("role=menuitem")
    # A menu may move with its tile when it is hidden. Quasar's script needs its element until then.
    menu.on("hide", act)
