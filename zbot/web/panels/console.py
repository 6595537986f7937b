"""Panel of the log lines of all nodes (`/rosout`), with filters."""

from __future__ import annotations

from collections import Counter
from datetime import datetime
from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.observer.log_ring import LEVELS, LogFilter, counts, level_of, newest
from zbot.web.page.command_line import command_line
from zbot.web.page.panel import Page, Panel

if TYPE_CHECKING:
    from zbot.observer.log_ring import LogLine

_HZ = 10.0
#: The largest number of lines in a page, and in one update.
_MOST_SHOWN = 1000
_MOST_AT_ONCE = 300
#: The largest number of characters in one update. The newest line is always shown.
_MOST_CHARACTERS = 200_000
#: The largest number of nodes in the list of the filter.
_MOST_LOGGERS = 300
_ANY = "All nodes"
_COUNTED = {30: "warning", 40: "error"}
_COLOURS = {10: "zb-muted", 20: "", 30: "zb-warn", 40: "zb-bad", 50: "zb-bad"}


class _Console:
    def __init__(self, page: Page) -> None:
        self.page = page
        self.logs = page.system.logs
        self.filter = LogFilter(logger=page.query.get("node", ""))
        self.begin = 0  # the number of the last cleared line
        self.last = 0  # the number of the last line that was read
        self.loggers: set[str] = set()
        self.counts: Counter[int] = Counter()
        self.is_paused = False
        self.is_reset = True
        with page.toolbar:
            self.build_filters()
        with ui.element("div").classes("zb-card zb-console").props("tabindex=0"):
            ui.element("table").classes("zb-log")
        self.empty = ui.label("No log line yet.").classes("zb-empty")
        self.show_command()
        page.live(self.update, _HZ)

    def build_filters(self) -> None:
        """Show the counts, the filters and the buttons."""
        self.numbers = {
            level: ui.label().classes(f"zb-log-count {_COLOURS[level]}") for level in _COUNTED
        }
        level = ui.select(LEVELS, value=self.filter.level, on_change=self.change)
        level.props('dense outlined options-dense aria-label="Level"').classes("zb-log-level")
        node = ui.select([_ANY], value=_ANY, on_change=self.change)
        node.props('dense outlined options-dense aria-label="Node"').classes("zb-log-node")
        text = ui.input(placeholder="Text", on_change=self.change)
        text.props('dense outlined clearable debounce=150 aria-label="Text"')
        text.classes("zb-search")
        self.level, self.node, self.text = level, node, text
        self.pause = ui.button("Pause", on_click=self.toggle_pause).props("outline dense")
        ui.button("Clear", on_click=self.clear).props("outline dense")

    def change(self) -> None:
        logger = "" if self.node.value in {_ANY, None} else str(self.node.value)
        self.filter = LogFilter(int(self.level.value), logger, (self.text.value or "").strip())
        self.is_reset = True
        self.show_command()

    def show_command(self) -> None:
        """Show the command that prints these lines."""
        condition = self.filter.condition
        words = ["--filter", condition] if condition else []
        self.page.show_command(command_line("topic", "echo", *words, "/rosout"))

    def toggle_pause(self) -> None:
        """Stop showing new lines, or continue with all lines that came meanwhile."""
        self.is_paused = not self.is_paused
        self.pause.set_text("Resume" if self.is_paused else "Pause")

    def clear(self) -> None:
        self.begin = self.last = self.logs.last
        self.counts.clear()
        self.is_reset = True

    def update(self) -> None:
        """Show the new lines. If the filter has changed, show all lines again."""
        new = [] if self.is_paused else self.logs.since(self.last)
        if not new and not self.is_reset:
            return
        self.last = new[-1].number if new else self.last
        self.count(new)
        if self.is_reset:
            wanted = list(filter(self.filter.matches, self.logs.since(self.begin)))
            seen = [line for line in wanted if line.number <= self.last]
            lines = sorted(seen, key=lambda line: line.stamp_ns)[-_MOST_SHOWN:]
        else:
            lines = list(filter(self.filter.matches, new))[-_MOST_AT_ONCE:]
        rows = [_row(line) for line in newest(lines, _MOST_CHARACTERS)]
        self.page.call("zbotConsole.add", rows, self.is_reset, _MOST_SHOWN)
        self.empty.set_visibility(self.is_reset and not rows)
        self.is_reset = False

    def count(self, new: list[LogLine]) -> None:
        """Count the new lines, and add their loggers to the choices of the filter."""
        self.counts.update(counts(new))
        for level, label in self.numbers.items():
            # Fatal lines count as errors.
            worse = (
                count for other, count in self.counts.items() if other > level == max(_COUNTED)
            )
            number = self.counts[level] + sum(worse)
            word = _COUNTED[level] if number == 1 else f"{_COUNTED[level]}s"
            label.set_text(f"{number} {word}" if number else "")
        unknown = {line.name for line in new} - self.loggers
        found = self.loggers | set(sorted(unknown)[: _MOST_LOGGERS - len(self.loggers)])
        if found != self.loggers:
            self.loggers = found
            self.node.set_options([_ANY, *sorted(found)])
            if self.filter.logger in found and self.node.value == _ANY:
                self.node.set_value(self.filter.logger)


def _row(line: LogLine) -> list[Any]:
    moment = datetime.fromtimestamp(max(line.stamp_ns, 0) / 1e9).astimezone()
    place = f"{line.file}:{line.line} {line.function}" if line.file else ""
    level = level_of(line)
    time = f"{moment:%H:%M:%S}.{moment.microsecond // 1000:03}"
    stamp_s = line.stamp_ns / 1e9
    return [time, LEVELS[level].upper(), line.name, line.text, place, _COLOURS[level], stamp_s]


def _build(page: Page) -> None:
    _Console(page)


PANEL = Panel("/console", "Console", "subject", _build)
