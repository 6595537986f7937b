"""Details of one status: its values, and the history of its levels and messages."""

from __future__ import annotations

import time
from datetime import datetime
from typing import TYPE_CHECKING

from nicegui import ui

from zbot.observer.value_text import duration
from zbot.web.page.table import Cell, Column, Table
from zbot.web.panels.diagnostics.diagnostics_log import Level

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.web.page.panel import Section
    from zbot.web.panels.diagnostics.diagnostics_log import Change, DiagnosticsLog, Entry

_HZ = 2.0
#: The colour of each level.
CLASSES = {
    Level.OK: "zb-good",
    Level.WARN: "zb-warn",
    Level.STALE: "zb-muted",
    Level.ERROR: "zb-bad",
}
_VALUES = (Column("Key", "zb-cut", "45%"), Column("Value", "zb-mono zb-wrap"))
_HISTORY = (
    Column("Time", "zb-number", "84px"),
    Column("Level", "", "72px"),
    Column("Message", "zb-wrap"),
)


class StatusDetails:
    """Details of a status.

    Args:
        section: The section that shows the details.
        log: Function that returns the log of the shown topic.
        path: The path of the status.
    """

    def __init__(self, section: Section, log: Callable[[], DiagnosticsLog], path: str) -> None:
        self._log, self._path = log, path
        self._labels: dict[str, ui.label] = {}
        self._absent = ui.label("This name has no status of its own.").classes("zb-muted")
        with ui.element("div").classes("zb-col") as self._place:
            with ui.element("div").classes("zb-facts"):
                for name in ("Level", "Message", "Hardware", "Age"):
                    ui.label(name).classes("zb-muted")
                    self._labels[name] = ui.label().classes("zb-wrap")
            self._values = Table(section.page, _VALUES)
            ui.label("History").classes("zb-heading")
            self._history = Table(section.page, _HISTORY)
        section.live(self._update, _HZ)

    def _update(self) -> None:
        entry = self._log().entries.get(self._path)
        self._absent.set_visibility(entry is None)
        self._place.set_visibility(entry is not None)
        if entry is not None:
            self._show(entry, time.time_ns())

    def _show(self, entry: Entry, now_ns: int) -> None:
        level, status = entry.level(now_ns), entry.status
        facts = {
            "Level": level.name,
            "Message": status.message,
            "Hardware": status.hardware_id,
            "Age": duration(entry.age_s(now_ns)),
        }
        for name, text in facts.items():
            self._labels[name].set_text(text)
        self._labels["Level"].classes(replace=f"zb-wrap {CLASSES[level]}")
        # A node may give one key twice.
        pairs = enumerate(status.values)
        self._values.show({f"{number} {key}": [key, value] for number, (key, value) in pairs})
        self._history.show(
            {
                f"{change.time_ns} {change.level}": _history_row(change)
                for change in reversed(entry.changes)
            }
        )


def _history_row(change: Change) -> list[str | Cell]:
    moment = datetime.fromtimestamp(change.time_ns / 1e9).astimezone()
    return [
        Cell(f"{moment:%H:%M:%S}", hint=f"{moment:%Y-%m-%d %H:%M:%S}"),
        Cell(change.level.name, CLASSES[change.level]),
        change.message,
    ]
