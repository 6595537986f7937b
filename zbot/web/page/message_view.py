"""Tree of a received message in the page, e.g. a response, feedback or a result."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.observer.value_text import tree
from zbot.web.page.table import Cell, Column, Table

if TYPE_CHECKING:
    from zbot.web.page.panel import Section

TREE_COLUMNS = (
    Column("Field", "zb-mono zb-cut", "40%"),
    Column("Value", "zb-mono zb-wrap"),
    Column("Type", "zb-muted zb-cut", "20%"),
)


class MessageView:
    """Heading with a tree below it. Both are hidden while there is no message.

    Args:
        section: The section of the page.
        title: The heading, e.g. `Reply`.
    """

    def __init__(self, section: Section, title: str) -> None:
        with ui.element("div").classes("zb-message") as self._box:
            with ui.element("div").classes("zb-row"):
                ui.label(title).classes("zb-heading")
                self._note = ui.label().classes("zb-muted")
            self._table = Table(section.page, TREE_COLUMNS)
            self._table.element.classes("zb-tree")
            self._error = ui.label().classes("zb-bad zb-wrap")
        self.clear()

    def clear(self) -> None:
        """Hide the heading and the tree."""
        self._box.set_visibility(False)

    def show(self, message: Any, note: str = "") -> None:
        """Show a message, and a note beside its title."""
        rows = {
            row.path: [
                Cell(row.name, indent=row.depth),
                Cell(row.text),
                Cell(row.type.rpartition("/")[2], hint=row.type),
            ]
            for row in tree(message)
        }
        self._table.show(rows)
        self._say("" if rows else "The message has no fields.", note)

    def show_error(self, error: Exception) -> None:
        """Show an error's message instead of a tree."""
        self._table.show({})
        self._say(str(error), "")
        self._error.classes(add="zb-bad")

    def _say(self, text: str, note: str) -> None:
        self._box.set_visibility(True)
        self._note.set_text(note)
        self._error.set_text(text)
        self._error.set_visibility(bool(text))
        self._error.classes(remove="zb-bad")
