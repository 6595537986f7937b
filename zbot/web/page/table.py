"""Table of the page. The server sends only changed cells to the browser."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import islice
from typing import TYPE_CHECKING, Any, TypeVar

from nicegui import ui

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from zbot.web.page.panel import Page

T = TypeVar("T")

#: A table shows the first rows only, because a longer one takes the server too long.
MOST_ROWS = 1_000


@dataclass(frozen=True, slots=True)
class Column:
    """Column of a table.

    Attributes:
        title: Its heading.
        classes: CSS classes of its cells, e.g. `zb-mono` or `zb-number`. `zb-spare` hides the
            column while details are shown beside the table. `zb-wide` hides it on a phone.
            `zb-long` is for text that may be cut.
        width: CSS width. If it is empty, the cells set the width.
    """

    title: str
    classes: str = ""
    width: str = ""


@dataclass(frozen=True, slots=True)
class Cell:
    """Cell of a table. It always contains text, never HTML."""

    text: str
    classes: str = ""  #: CSS classes in addition to the column's classes, e.g. `zb-bad`
    indent: int = 0
    address: str = ""  #: target of a link, on this server: `/plot?curve=/pose.x`
    hint: str = ""  #: tooltip


class Table:
    """Table of the page.

    Args:
        page: The page.
        columns: The columns.
        on_choose: Called with the key of a clicked row. If None, users cannot choose rows.
    """

    def __init__(
        self,
        page: Page,
        columns: Sequence[Column],
        on_choose: Callable[[str], None] | None = None,
    ) -> None:
        self._page = page
        self._classes = [column.classes for column in columns]
        self._order: list[str] = []
        self._cells: dict[str, list[Any]] = {}
        self._chosen: str | None = None
        self._shown_choice: str | None = None
        self.element = ui.element("table").classes("zb-table")
        with self.element:
            _head(columns)
            ui.element("tbody")
        self._more = ui.label().classes("zb-empty")
        self._more.set_visibility(False)
        if on_choose is not None:
            self.element.classes("zb-choosable")
            page.on_choose(f"c{self.element.id}", on_choose)

    def choose(self, key: str | None) -> None:
        """Choose a row, or no row if the key is None. The next `show` highlights the row."""
        self._chosen = key

    def show(self, rows: Mapping[str, Sequence[str | Cell]], *, left_out: int = 0) -> None:
        """Show at most `MOST_ROWS` rows in the given order. Only changes are sent to the browser.

        Args:
            rows: The rows by key.
            left_out: The number of rows that the caller has left out already.
        """
        rows, more = first_rows(rows)
        self._more.set_text(f"and {more + left_out:,} more: a filter shows others")
        self._more.set_visibility(bool(more + left_out))
        order = list(rows)
        cells = {key: [_plain(cell) for cell in row] for key, row in rows.items()}
        changed = {
            key: _difference(self._cells.get(key), row)
            for key, row in cells.items()
            if self._cells.get(key) != row
        }
        is_same = order == self._order
        if is_same and not changed and self._chosen == self._shown_choice:
            return
        self._order, self._cells, self._shown_choice = order, cells, self._chosen
        self._page.call(
            "zbot.table.show",
            self.element.id,
            self._classes,
            None if is_same else order,
            changed,
            self._chosen,
        )


def first_rows(rows: Mapping[str, T]) -> tuple[Mapping[str, T], int]:
    """Return the rows that a table shows, and the number of the others."""
    more = len(rows) - MOST_ROWS
    return (rows, 0) if more <= 0 else (dict(islice(rows.items(), MOST_ROWS)), more)


def _head(columns: Sequence[Column]) -> None:
    with ui.element("colgroup"):
        for column in columns:
            col = ui.element("col").style(f"width: {column.width}" if column.width else "")
            col.classes(_only(column, "zb-spare", "zb-wide"))
    with ui.element("thead"), ui.element("tr"):
        for column in columns:
            with ui.element("th").classes(_only(column, "zb-number", "zb-spare", "zb-wide")):
                ui.label(column.title)


def _only(column: Column, *names: str) -> str:
    """Return the given classes that the column has."""
    return " ".join(name for name in names if name in column.classes.split())


def _plain(cell: str | Cell) -> Any:
    if isinstance(cell, str):
        return cell
    facts = {
        "c": cell.classes,
        "i": cell.indent,
        "h": cell.address,
        "d": cell.hint,
    }
    return {"t": cell.text} | {name: value for name, value in facts.items() if value}


def _difference(old: list[Any] | None, new: list[Any]) -> list[Any]:
    if old is None:
        return new
    return [
        None if index < len(old) and old[index] == cell else cell for index, cell in enumerate(new)
    ]
