"""A list on the left, and on the right what was chosen of it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nicegui import ui

from zbot.web.table import Cell, Table

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from zbot.graph.snapshot import Snapshot
    from zbot.web.panel import Frame, Part
    from zbot.web.table import Column

# A change of the graph is to be seen at once, and costs nothing while there is none.
_LIST_HZ = 10.0


class ListPanel:
    """Rows that follow the graph, with a filter, and the details of the chosen one.

    Args:
        frame: The page.
        columns: Of the table.
        rows: Returns the rows by their keys, given the graph and whether to show hidden ones.
        details: Shows one row's details where it is called, given its key and what closes them.
        key: What the address calls the chosen row: `?service=/spawn`.
        command: The command that prints the list.
        empty: What stands there if there are no rows.
        hidden: Label of the tick for rows that are hidden at first.
        version: Rows are asked for again when what this returns has changed, or the graph has.
        is_narrow: Whether the list needs little room beside details.
    """

    def __init__(
        self,
        frame: Frame,
        *,
        columns: Sequence[Column],
        rows: Callable[[Snapshot, bool], Mapping[str, Sequence[str | Cell]]],
        details: Callable[[Part, str], object],
        key: str,
        command: str,
        empty: str,
        hidden: str,
        version: Callable[[], object] = lambda: None,
        is_narrow: bool = False,
    ) -> None:
        self._frame, self._rows, self._details = frame, rows, details
        self._key, self._command, self._version = key, command, version
        self._filter, self._shows_hidden = "", False
        self._seen: object = None
        self._part: Part | None = None
        self._chosen: str | None = None
        with frame.toolbar:
            search = ui.input(placeholder="Filter", on_change=self._search)
            search.props('dense outlined clearable aria-label="Filter"').classes("zb-search")
            ui.checkbox(hidden, on_change=self._toggle).props("dense")
        with ui.element("div").classes("zb-split") as self._split:
            with ui.element("div").classes("zb-card zb-list"):
                self._table = Table(frame, columns, self.choose)
                self._empty = ui.label(empty).classes("zb-empty")
            self._side = ui.element("div").classes("zb-card zb-side")
        self._split.classes("zb-split-narrow" if is_narrow else "")
        frame.live(self._update, _LIST_HZ)
        chosen = frame.query.get(key)
        if chosen:
            self.choose(chosen)
        else:
            self.close()

    def _search(self, event: object) -> None:
        self._filter = (getattr(event, "value", None) or "").strip().lower()

    def _toggle(self, event: object) -> None:
        self._shows_hidden = bool(getattr(event, "value", False))

    def _update(self) -> None:
        revision = self._frame.system.revision
        state = (revision, self._version(), self._filter, self._shows_hidden)
        if state == self._seen:
            return
        self._seen = state
        found = self._rows(self._frame.system.snapshot(), self._shows_hidden)
        shown = {
            key: row
            for key, row in found.items()
            if any(self._filter in _text(cell).lower() for cell in row)
        }
        self._table.show(shown)
        self._empty.set_visibility(not shown)

    def choose(self, key: str) -> None:
        """Show a row's details, or no longer if they are shown."""
        if self._chosen == key:
            self.close()
            return
        self._end_details()
        self._chosen = key
        self._frame.set_query(**{self._key: key})
        self._table.choose(key)
        self._seen = None
        self._split.classes(add="zb-split-open")
        self._part = self._frame.part()
        with self._side:
            with ui.element("div").classes("zb-side-head"):
                ui.label(key).classes("zb-mono zb-name").tooltip(key)
                close = ui.button(icon="close", on_click=self.close)
                close.props('flat round dense aria-label="Close"')
            self._details(self._part, key)

    def close(self) -> None:
        """Show the list alone."""
        self._end_details()
        self._chosen = None
        self._frame.set_query()
        self._frame.show_command(self._command)
        self._table.choose(None)
        self._seen = None
        self._split.classes(remove="zb-split-open")

    def _end_details(self) -> None:
        if self._part is not None:
            self._part.close()
        self._part = None
        self._side.clear()


def _text(cell: str | Cell) -> str:
    return cell.text if isinstance(cell, Cell) else cell
