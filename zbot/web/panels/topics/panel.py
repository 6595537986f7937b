"""Panel of topics, with nodes, rates, last messages, and details of the chosen topic."""

from __future__ import annotations

import shlex
from typing import TYPE_CHECKING

from nicegui import ui

from zbot.errors.suggestion import question
from zbot.names import is_hidden
from zbot.observer.value_text import amount, brief
from zbot.web.page.panel import Page, Panel
from zbot.web.page.table import MOST_ROWS, Cell, Column, Table
from zbot.web.panels.topics.topic_details import show_topic
from zbot.web.panels.topics.topic_rows import FoldedRow, folded, topic_rows

if TYPE_CHECKING:
    from zbot.observer.watch import Watch
    from zbot.web.page.panel import Section
    from zbot.web.panels.topics.topic_rows import TopicRow

#: The page subscribes to at most this number of the list's topics. A filter shortens the list.
_MOST_WATCHED = 300
#: A list with more topics is folded by namespace. About two screens of a laptop.
_MOST_UNFOLDED = 40
# Updates a second. Users cannot read numbers that change more often.
_LIST_HZ = 2.0
_COLUMNS = (
    Column("Topic", "zb-mono zb-cut"),
    Column("Type", "zb-muted zb-cut zb-spare zb-wide"),
    Column("Pub", "zb-number zb-wide", "56px"),
    Column("Sub", "zb-number zb-wide", "56px"),
    Column("Rate", "zb-number", "84px"),
    Column("Data", "zb-number zb-wide", "92px"),
    Column("Last message", "zb-mono zb-cut zb-long zb-spare zb-wide"),
)


class _Topics:
    """List of topics, and the details of one topic."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.filter = ""
        self.hidden = False
        self.watches: dict[str, Watch] = {}
        self.details: Section | None = None
        self.opened: frozenset[str] = frozenset()  # namespaces
        self.seen: object = None
        self.topics: dict[str, TopicRow] = {}
        self.shown: list[FoldedRow] = []
        with page.toolbar:
            search = ui.input(placeholder="Filter", on_change=self.search)
            search.props('dense outlined clearable aria-label="Filter"').classes("zb-search")
            ui.checkbox("Hidden", on_change=self.toggle).props("dense")
        with ui.element("div").classes("zb-split") as self.split:
            with ui.element("div").classes("zb-card zb-list"):
                self.table = Table(page, _COLUMNS, self.choose)
                self.empty = ui.label("No topic yet: start a node, e.g. zbot run talker")
                self.empty.classes("zb-empty")
            self.side = ui.element("div").classes("zb-card zb-side")
        page.live(self.update, _LIST_HZ)
        chosen = page.query.get("topic")
        if chosen:
            self.choose(chosen)
        else:
            self.close()

    def search(self, event: object) -> None:
        """Show only topics whose name or type contains the text in the input."""
        self.filter = (getattr(event, "value", None) or "").strip().lower()

    def toggle(self, event: object) -> None:
        self.hidden = bool(getattr(event, "value", False))

    def update(self) -> None:
        system = self.page.system
        state = (system.revision, self.filter, self.hidden, self.opened)
        if state != self.seen:
            self.seen = state
            self.topics = {topic.name: topic for topic in self.find()}
            self.shown = self.fold()
            self.match_watches()
        first = self.shown[:MOST_ROWS]
        left_out = len(self.shown) - len(first)
        self.table.show({row.name: self.row(row) for row in first}, left_out=left_out)
        self.empty.set_visibility(not self.topics)

    def find(self) -> list[TopicRow]:
        system = self.page.system
        return [
            topic
            for topic in topic_rows(system.snapshot(), system.node_name)
            if (self.hidden or not is_hidden(topic.name))
            and self.filter in f"{topic.name} {' '.join(topic.types)}".lower()
        ]

    def fold(self) -> list[FoldedRow]:
        """Return the rows of the list. A short or filtered list has a row for each topic."""
        if self.filter or len(self.topics) <= _MOST_UNFOLDED:
            return [FoldedRow(name, 0) for name in self.topics]
        return folded(list(self.topics), self.opened)

    def match_watches(self) -> None:
        """Watch the first topics of the list, and drop the watches of all other topics."""
        names = set([row.name for row in self.shown if not row.names][:_MOST_WATCHED])
        for name in self.watches.keys() - names:
            self.page.drop(self.watches.pop(name))
        for name in sorted(names - self.watches.keys()):
            self.watches[name] = self.page.watch(name)

    def row(self, row: FoldedRow) -> list[str | Cell]:
        if row.names:
            return self.namespace_row(row)
        topic = self.topics[row.name]
        watch = self.watches.get(topic.name)
        rate = amount(watch.rate_hz, "Hz") if watch else ""
        size = amount(watch.bytes_per_second, "B/s") if watch else ""
        message = watch.latest if watch else None
        return [
            _name(topic, row.depth),
            _types(topic),
            str(len(topic.publishers)),
            str(len(topic.subscriptions)),
            rate,
            size,
            brief(message) if message is not None else "",
        ]

    def namespace_row(self, row: FoldedRow) -> list[str | Cell]:
        arrow = "▾" if row.name in self.opened else "▸"
        topics = [self.topics[name] for name in row.names]
        problems = [topic for topic in topics if topic.guess is not None or topic.has_clash]
        hint = f"there is a problem with {problems[0].name}" if problems else ""
        text = f"{arrow} {row.name} {len(topics)}\N{NO-BREAK SPACE}topics"
        return [Cell(text, "zb-bad" if problems else "", row.depth, hint=hint), *[""] * 6]

    def choose(self, topic: str) -> None:
        """Show a topic's details, or close them if they are shown. Open or close a namespace."""
        if topic.endswith("/"):
            self.opened ^= {topic}
            return
        if self.details is not None and self.page.query.get("topic") == topic:
            self.close()
            return
        self.end_details()
        self.page.set_query(topic=topic)
        self.page.show_command(f"zbot topic echo {shlex.quote(topic)}")
        self.table.choose(topic)
        self.split.classes(add="zb-split-open")
        self.details = self.page.section()
        with self.side:
            show_topic(self.details, topic, self.close)

    def close(self) -> None:
        self.end_details()
        self.page.set_query()
        self.page.show_command("zbot topic list -t")
        self.table.choose(None)
        self.split.classes(remove="zb-split-open")

    def end_details(self) -> None:
        if self.details is not None:
            self.details.close()
        self.details = None
        self.side.clear()


def _name(topic: TopicRow, depth: int) -> Cell:
    if topic.guess is not None:
        hint = f"nobody publishes {topic.name}{question([topic.guess], '; ')}"
        return Cell(topic.name, "zb-bad", depth, hint=hint)
    return Cell(topic.name, indent=depth, hint=topic.name)


def _types(topic: TopicRow) -> Cell:
    text = ", ".join(topic.types)
    if topic.has_clash:
        return Cell(text, "zb-bad", hint=f"nodes with different types exchange no messages: {text}")
    return Cell(text, hint=text)


def _build(page: Page) -> None:
    _Topics(page)


PANEL = Panel("/topics", "Topics", "lan", _build)
