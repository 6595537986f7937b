"""Panel of a page of one's own: panels side by side, which the browser keeps and a link shares."""

from __future__ import annotations

import zlib
from functools import partial
from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.web.page.layout import Layout, LayoutError, checked_tile, read_layout
from zbot.web.page.panel import Page, Panel
from zbot.web.panels.layout.tile import Tile

if TYPE_CHECKING:
    from collections.abc import Callable

_PATH = "/layout"
#: What the menu of a tile does.
_CHANGES: dict[str, Callable[[Layout, int, int], Layout]] = {
    "Move left": lambda layout, row, place: layout.moved_sideways(row, place, -1),
    "Move right": lambda layout, row, place: layout.moved_sideways(row, place, 1),
    "Move up": Layout.moved_up,
    "Move down": Layout.moved_down,
    "Close": Layout.without,
}
_HOW = "Add a panel. The browser keeps this page, and its address shares it."


class LayoutPanel:
    """The tiles of a layout, and the toolbar that changes them."""

    def __init__(self, page: Page) -> None:
        self._page = page
        self._panels = {
            panel.path.strip("/"): panel for panel in page.server.panels if panel.path != _PATH
        }
        self._layout = Layout()
        self._tiles: list[list[Tile]] = []
        self._rows: list[ui.element] = []
        self._count = 0  # of all tiles so far
        self._is_own = False  # whether the browser keeps this layout, not only the address
        self._add_toolbar()
        self._said = ui.label(_HOW).classes("zb-empty").props("role=status")
        self._place = ui.element("div").classes("zb-layout")
        page.show_command("zbot web --layout layout.json")
        ui.on("zbot_layout_kept", lambda event: self._show_kept(event.args))
        ui.on("zbot_tile", lambda event: self._note(*event.args))
        if "layout" in page.query:
            self._show_text(page.query["layout"])
        else:
            page.call("zbot.layout.ask", self._key)

    def _add_toolbar(self) -> None:
        titles = {name: panel.title for name, panel in self._panels.items()}
        with self._page.toolbar:
            self._title = ui.label().classes("zb-muted zb-layout-title")
            self._reset = ui.button("Reset", on_click=self._show_ready_made)
            self._reset.props("outline dense").tooltip("Show the layout of this server again")
            self._adder = ui.select(titles, label="Add a panel", on_change=self._on_choice)
            self._adder.props("dense outlined options-dense").classes("zb-picture-topic")
            self._save = ui.button("Save", on_click=self._save_file).props("outline dense")
            self._save.tooltip("Save a file for zbot web --layout")
            self._copy = ui.button("Copy link").props("outline dense")
            self._copy.on("click", js_handler="() => zbot.layout.copyLink()")
        self._reset.set_visibility(False)

    @property
    def _key(self) -> str:
        """The key under which the browser keeps the layout. A new lesson has a new key."""
        ready = self._page.server.layout
        return f"{zlib.crc32(ready.text().encode()):08x}" if ready is not None else ""

    def _show_kept(self, kept: Any) -> None:
        """Show the layout that the browser has kept, or that of the server."""
        self._is_own = True
        if isinstance(kept, str) and kept:
            self._show_text(kept)
        else:
            self._show(self._page.server.layout or Layout())

    def _show_text(self, text: str) -> None:
        try:
            self._show(read_layout(text, self._panels))
        except LayoutError as error:
            hint = f" ({error.hint})" if error.hint else ""
            self._show(Layout())
            self._said.set_text(f"This address has no layout: {error}{hint}")

    def _show_ready_made(self) -> None:
        self._page.call("zbot.layout.keep", self._key, None)
        self._page.set_query()
        self._is_own = True
        self._show(self._page.server.layout or Layout())

    def _show(self, layout: Layout) -> None:
        """Show another layout. All panels are loaded."""
        for tiles in self._tiles:
            for tile in tiles:
                tile.element.delete()
        self._tiles = []
        self._layout = layout
        self._said.set_text(_HOW)
        with self._place:
            self._arrange([[self._new_tile(one) for one in row] for row in layout.rows])
        self._show_state()

    def _new_tile(self, address: str) -> Tile:
        self._count += 1
        key = str(self._count)
        actions = {name: partial(self._change, key, change) for name, change in _CHANGES.items()}
        return Tile(key, self._panels[address.partition("?")[0]], address, actions)

    def _on_choice(self) -> None:
        name = str(self._adder.value or "")
        self._adder.set_value(None)
        if name:
            self._set(self._layout.with_tile(name))

    def _place_of(self, key: str) -> tuple[int, int] | None:
        for row, tiles in enumerate(self._tiles):
            for place, tile in enumerate(tiles):
                if tile.key == key:
                    return row, place
        return None

    def _change(self, key: str, change: Callable[[Layout, int, int], Layout]) -> None:
        at = self._place_of(key)
        if at is not None:
            self._set(change(self._layout, *at))

    def _set(self, layout: Layout) -> None:
        """Show a changed layout. Panels that stay in their rows are not loaded again."""
        if layout == self._layout:
            return
        self._layout, self._is_own = layout, True
        free = [tile for tiles in self._tiles for tile in tiles]
        with self._place:
            rows = [[self._taken(free, address) for address in row] for row in layout.rows]
        for tile in free:
            tile.element.delete()
        self._arrange(rows)
        self._show_state()
        self._keep()

    def _taken(self, free: list[Tile], address: str) -> Tile:
        """Return a tile with an address: one that is shown now, or a new one."""
        found = next((tile for tile in free if tile.address == address), None)
        if found is None:
            return self._new_tile(address)
        free.remove(found)
        return found

    def _arrange(self, rows: list[list[Tile]]) -> None:
        while len(self._rows) < len(rows):
            with self._place:
                self._rows.append(ui.element("div").classes("zb-layout-row"))
        for element, tiles in zip(self._rows, rows, strict=False):
            for place, tile in enumerate(tiles):
                if tile.element.parent_slot is not element.default_slot or (
                    element.default_slot.children.index(tile.element) != place
                ):
                    tile.element.move(element, target_index=place)
        self._tiles = rows
        for number, element in enumerate(self._rows):
            element.set_visibility(number < len(rows))

    def _show_state(self) -> None:
        ready = self._page.server.layout
        is_empty = not self._layout.rows
        self._title.set_text(self._layout.title)
        self._said.set_visibility(is_empty)
        self._reset.set_visibility(ready is not None and ready != self._layout)
        self._adder.set_visibility(not self._layout.is_full)
        for button in (self._save, self._copy):
            button.set_visibility(not is_empty)

    def _note(self, key: Any, address: Any) -> None:
        """Note that the panel in a tile has changed its address, e.g. after a choice."""
        at = self._place_of(str(key))
        if at is None:
            return
        try:
            tile = checked_tile(str(address).lstrip("/"), self._panels)
        except LayoutError:
            return  # the frame shows another page
        if tile == self._layout.rows[at[0]][at[1]]:
            return
        layout = self._layout.with_address(*at, tile)
        if layout == self._layout:
            ui.notify("The layout keeps the former address of this panel: the new one is too long.")
            return
        self._tiles[at[0]][at[1]].set_address(tile)
        self._layout = layout
        self._show_state()
        self._keep()

    def _keep(self) -> None:
        """Put the layout into the address, and let the browser keep it."""
        text = self._layout.text()
        self._page.set_query(layout=text)
        if self._is_own:
            self._page.call("zbot.layout.keep", self._key, text)

    def _save_file(self) -> None:
        text = self._layout.file_text()
        self._page.call("zbot.save", "layout.json", text, "application/json")


def _build(page: Page) -> None:
    LayoutPanel(page)


PANEL = Panel(_PATH, "Layout", "dashboard", _build)
