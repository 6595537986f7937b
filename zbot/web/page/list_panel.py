"""Panel with a list on the left and the details of the chosen row on the right."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nicegui import ui

from zbot.web.page.table import Cell, Table

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from zbot.graph.snapshot import Snapshot
    from zbot.web.page.panel import Page, Section
    from zbot.web.page.table import Column

# At this rate, a change is visible within 0.25 s, and a launch of many nodes makes few lists.
# Without a change, an update does nothing.
_LIST_HZ = 4.0


class ListPanel:
    """List that shows changes of the graph. It has a filter and details of the chosen row.

    Args:
        page: The page.
        columns: The columns of the table.
        rows: Takes the graph and a bool (True shows hidden rows), and returns the rows by key.
        details: Takes a section and a row's key, and adds the row's details to the current element.
        key: The address's parameter for the chosen row, e.g. `service` for `?service=/spawn`.
        command: The command that prints the list.
        empty: The text to show if there are no rows.
        hidden: The label of the checkbox that shows hidden rows.
        version: Returns a value. When this value or the graph changes, `rows` is called again.
        is_narrow: Whether the list needs little space beside the details.
    """

    def __init__(
        self,
        page: Page,
        *,
        columns: Sequence[Column],
        rows: Callable[[Snapshot, bool], Mapping[str, Sequence[str | Cell]]],
        details: Callable[[Section, str], object],
        key: str,
        command: str,
        empty: str,
        hidden: str,
        version: Callable[[], object] = lambda: None,
        is_narrow: bool = False,
    ) -> None:
        self._page, self._rows, self._details = page, rows, details
        self._key, self._command, self._version = key, command, version
        self._filter, self._shows_hidden = "", False
        self._seen: object = None
        self._section: Section | None = None
        self._chosen: str | None = None
        with page.toolbar:
            search = ui.input(placeholder="Filter", on_change=self._search)
            search.props('dense outlined clearable aria-label="Filter"').classes("zb-search")
            ui.checkbox(hidden, on_change=self._toggle).props("dense")
        with ui.element("div").classes("zb-split") as self._split:
            with ui.element("div").classes("zb-card zb-list"):
                self._table = Table(page, columns, self.choose)
                self._empty = ui.label(empty).classes("zb-empty")
            self._side = ui.element("div").classes("zb-card zb-side")
        self._split.classes("zb-split-narrow" if is_narrow else "")
        page.live(self._update, _LIST_HZ)
        chosen = page.query.get(key)
        if chosen:
            self.choose(chosen)
        else:
            self.close()

    def set_command(self, command: str) -> None:
        """Change the command that prints the list, and show it."""
        self._command = command
        self._page.show_command(command)

    def _search(self, event: object) -> None:
        self._filter = (getattr(event, "value", None) or "").strip().lower()

    def _toggle(self, event: object) -> None:
        self._shows_hidden = bool(getattr(event, "value", False))

    def _update(self) -> None:
        revision = self._page.system.revision
        state = (revision, self._version(), self._filter, self._shows_hidden)
        if state == self._seen:
            return
        self._seen = state
        found = self._rows(self._page.system.snapshot(), self._shows_hidden)
        shown = {
            key: row
            for key, row in found.items()
            if any(self._filter in _text(cell).lower() for cell in row)
        }
        self._table.show(shown)
        self._empty.set_visibility(not shown)

    def choose(self, key: str) -> None:
        """Show a row's details. Close them if they are already shown."""
        if self._chosen == key:
            self.close()
            return
        self._end_details()
        self._chosen = key
        self._page.set_query(**{**self._page.query, self._key: key})
        self._table.choose(key)
        self._seen = None
        self._split.classes(add="zb-split-open")
        self._section = self._page.section()
        with self._side:
            with ui.element("div").classes("zb-side-head"):
                ui.label(key).classes("zb-mono zb-name").tooltip(key)
                close = ui.button(icon="close", on_click=self.close)
                close.props('flat round dense aria-label="Close"')
            self._details(self._section, key)

    def close(self) -> None:
        """Close the details."""
        self._end_details()
        self._chosen = None
        others = {name: value for name, value in self._page.query.items() if name != self._key}
        self._page.set_query(**others)
        self._page.show_command(self._command)
        self._table.choose(None)
        self._seen = None
        self._split.classes(remove="zb-split-open")

    def _end_details(self) -> None:
        if self._section is not None:
            self._section.close()
        self._section = None
        self._side.clear()


def _text(cell: str | Cell) -> str:
    return cell.text if isinstance(cell, Cell) else cell
