"""Panel of diagnostics: a tree of names with levels, the worst first, as rqt_robot_monitor."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from nicegui import ui

from zbot.errors import counted
from zbot.observer.value_text import duration
from zbot.threads.deadline import Deadline
from zbot.web.page.command_line import command_line
from zbot.web.page.list_panel import ListPanel
from zbot.web.page.panel import Page, Panel
from zbot.web.page.table import Cell, Column
from zbot.web.panels.diagnostics.diagnostics_log import DiagnosticsLog, Level
from zbot.web.panels.diagnostics.status_details import CLASSES, StatusDetails
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot
    from zbot.observer.watch import Watch
    from zbot.web.page.panel import Section
    from zbot.web.panels.diagnostics.diagnostics_log import Branch

_TYPE = "diagnostic_msgs/msg/DiagnosticArray"
#: The topics that are shown first, if a node publishes them.
_USUAL = ("/diagnostics_agg", "/diagnostics")
_HZ = 2.0
#: Messages that wait while the page is hidden.
_KEPT = 3000
#: Longest time to read messages at once. More would delay other panels.
_LOOK_S = 0.03
#: How many topics of the graph are received. The user can choose any other topic.
_MOST_TOPICS = 10
_COLUMNS = (
    Column("Name", "zb-cut"),
    Column("Level", "", "72px"),
    Column("Message", "zb-cut zb-spare", "40%"),
    Column("Age", "zb-number zb-wide", "80px"),
)
_NOUNS = {Level.ERROR: "error", Level.STALE: "stale", Level.WARN: "warning"}


def diagnostics_topics(graph: Snapshot) -> list[str]:
    """Return the topics on which nodes publish diagnostics, the aggregated ones first."""
    found = {end.name for end in graph.of_kind(EntityKind.PUBLISHER) if end.type_name == _TYPE}
    return [*(name for name in _USUAL if name in found), *sorted(found.difference(_USUAL))]


class _Diagnostics:
    def __init__(self, page: Page) -> None:
        self.page = page
        self.watches: dict[str, Watch] = {}
        self.seen: dict[str, int] = {}
        self.logs: dict[str, DiagnosticsLog] = {}
        self.number = 0  # how many times the statuses were read
        self.revision = -1
        self.topic = page.query.get("topic", "")
        with page.toolbar:
            self.summary = ui.label().classes("zb-muted").props("role=status")
            self.chooser = ui.select([], on_change=self.choose)
            self.chooser.props('dense outlined options-dense aria-label="Topic"')
        for topic in _USUAL:
            self.add(topic)
        page.live(self.look, _HZ)
        self.list = ListPanel(
            page,
            columns=_COLUMNS,
            rows=self.rows,
            details=self.details,
            key="status",
            command=self.command,
            empty="No diagnostics yet: a node publishes them, e.g. with diagnostic_updater",
            hidden="Only problems",
            version=lambda: self.number,
        )

    @property
    def log(self) -> DiagnosticsLog:
        """The statuses of the shown topic."""
        return self.logs.get(self.topic) or DiagnosticsLog()

    @property
    def command(self) -> str:
        """The command that prints the shown topic."""
        return command_line("topic", "echo", self.topic or _USUAL[1])

    def details(self, section: Section, path: str) -> None:
        """Add the details of a status."""
        StatusDetails(section, lambda: self.log, path)
        section.page.show_command(self.command)

    def add(self, topic: str) -> None:
        """Receive a topic, also while the page is hidden, so that the history has no gaps."""
        self.watches[topic] = self.page.watch(topic, _TYPE, keep=_KEPT, even_hidden=True)
        self.watches[topic].resume()
        self.seen[topic], self.logs[topic] = 0, DiagnosticsLog()

    def look(self) -> None:
        """Read the new messages of all topics."""
        if self.revision != self.page.system.revision:
            self.revision = self.page.system.revision
            self.match(diagnostics_topics(self.page.system.snapshot()))
        deadline = Deadline(_LOOK_S)
        for topic, watch in self.watches.items():
            for record, message in watch.read_since(self.seen[topic], deadline):
                self.seen[topic] = record.number
                if message is not None:
                    self.logs[topic].take(message, record.received_ns)
        self.number += 1
        counts = self.log.counts(time.time_ns())
        self.summary.set_text(_summary(counts))

    def match(self, topics: list[str]) -> None:
        """Offer the topics of the graph, and receive them. The first choice is the first topic."""
        if not self.topic and topics:
            self.show(topics[0])
        # The shown topic stays when its publisher ends. A name of the address may be no topic.
        shown = {self.topic} & {*topics, *self.watches}
        wanted = {*_USUAL, *topics[:_MOST_TOPICS], *shown}
        for topic in self.watches.keys() - wanted:
            self.page.drop(self.watches.pop(topic))
            del self.seen[topic], self.logs[topic]
        for topic in sorted(wanted - self.watches.keys()):
            self.add(topic)
        offered = list(dict.fromkeys([*topics, *([self.topic] if self.topic else [])]))
        self.chooser.set_options(offered, value=self.topic or None)
        self.chooser.set_visibility(len(offered) > 1)

    def choose(self) -> None:
        """Show the topic that the user has chosen."""
        chosen = str(self.chooser.value or "")
        if chosen and chosen != self.topic:
            self.show(chosen)
            self.revision = -1  # so that the topic is received
            self.page.set_query(**{**self.page.query, "topic": chosen})

    def show(self, topic: str) -> None:
        """Show the statuses of a topic."""
        self.topic = topic
        self.number += 1
        self.list.set_command(self.command)

    def rows(self, _graph: Snapshot, only_problems: bool) -> dict[str, list[str | Cell]]:
        now_ns = time.time_ns()
        return {
            branch.path: _row(branch, now_ns)
            for branch in self.log.tree(now_ns).worst_first()
            if not only_problems or branch.level is not Level.OK
        }


def _row(branch: Branch, now_ns: int) -> list[str | Cell]:
    entry = branch.entry
    message = entry.status.message if entry is not None else ""
    return [
        Cell(branch.name, indent=branch.depth, hint=branch.path),
        Cell(branch.level.name, CLASSES[branch.level]),
        Cell(message, hint=message),
        duration(entry.age_s(now_ns)) if entry is not None else "",
    ]


def _summary(counts: dict[Level, int]) -> str:
    if not any(counts.values()):
        return ""
    found = [
        f"{count} stale" if level is Level.STALE else counted(count, _NOUNS[level])
        for level, count in counts.items()
        if count and level is not Level.OK
    ]
    return ", ".join(found) or "all OK"


def _build(page: Page) -> None:
    _Diagnostics(page)


PANEL = Panel("/diagnostics", "Diagnostics", "monitor_heart", _build)
