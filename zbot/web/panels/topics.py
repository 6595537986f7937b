"""The panel of topics: who uses them, how much comes, and the details of the chosen one."""

from __future__ import annotations

import shlex
from typing import TYPE_CHECKING

from nicegui import ui

from zbot.names import is_hidden
from zbot.web.panel import Frame, Panel
from zbot.web.table import Cell, Column, Table
from zbot.web.topic_details import show_topic
from zbot.web.topic_rows import topic_rows
from zbot.web.value_text import amount, brief

if TYPE_CHECKING:
    from zbot.web.panel import Part
    from zbot.web.topic_rows import TopicRow
    from zbot.web.watch import Watch

#: Rows whose messages are counted; whoever has more topics finds theirs by the filter.
_MOST_WATCHED = 300
# As fast as numbers can be read.
_LIST_HZ = 2.0
_COLUMNS = (
    Column("Topic", "zb-mono zb-cut"),
    Column("Type", "zb-muted zb-cut zb-spare"),
    Column("Pub", "zb-number", "56px"),
    Column("Sub", "zb-number", "56px"),
    Column("Rate", "zb-number", "84px"),
    Column("Data", "zb-number", "92px"),
    Column("Last message", "zb-mono zb-cut zb-spare"),
)


class _Topics:
    """The list, and beside it the details of one topic."""

    def __init__(self, frame: Frame) -> None:
        self.frame = frame
        self.filter = ""
        self.hidden = False
        self.watches: dict[str, Watch] = {}
        self.details: Part | None = None
        self.seen: tuple[int, str, bool] | None = None
        self.topics: list[TopicRow] = []
        with frame.toolbar:
            search = ui.input(placeholder="Filter", on_change=self.search)
            search.props('dense outlined clearable aria-label="Filter"').classes("zb-search")
            ui.checkbox("Hidden", on_change=self.toggle).props("dense")
        with ui.element("div").classes("zb-split") as self.split:
            with ui.element("div").classes("zb-card zb-list"):
                self.table = Table(frame, _COLUMNS, self.choose)
                self.empty = ui.label("No topic yet: start a node, e.g. zbot run talker")
                self.empty.classes("zb-empty")
            self.side = ui.element("div").classes("zb-card zb-side")
        frame.live(self.update, _LIST_HZ)
        chosen = frame.query.get("topic")
        if chosen:
            self.choose(chosen)
        else:
            self.close()

    def search(self, event: object) -> None:
        """Show only topics whose name or type has a text."""
        self.filter = (getattr(event, "value", None) or "").strip().lower()

    def toggle(self, event: object) -> None:
        """Show topics that tools hide, too."""
        self.hidden = bool(getattr(event, "value", False))

    # -- the list ------------------------------------------------------------------------------

    def update(self) -> None:
        """Show the topics as they are now."""
        system = self.frame.system
        state = (system.revision, self.filter, self.hidden)
        if state != self.seen:
            self.seen = state
            self.topics = self.find()
            self.match_watches()
        self.table.show({topic.name: self.row(topic) for topic in self.topics})
        self.empty.set_visibility(not self.topics)

    def find(self) -> list[TopicRow]:
        """Return the topics that the filter leaves."""
        system = self.frame.system
        return [
            topic
            for topic in topic_rows(system.snapshot(), system.node_name)
            if (self.hidden or not is_hidden(topic.name))
            and self.filter in f"{topic.name} {' '.join(topic.types)}".lower()
        ]

    def match_watches(self) -> None:
        """Watch what is shown, and nothing else."""
        names = {topic.name for topic in self.topics[:_MOST_WATCHED]}
        for name in self.watches.keys() - names:
            self.frame.drop(self.watches.pop(name))
        for name in sorted(names - self.watches.keys()):
            self.watches[name] = self.frame.watch(name)

    def row(self, topic: TopicRow) -> list[str | Cell]:
        """Return the cells of one topic."""
        watch = self.watches.get(topic.name)
        rate = amount(watch.rate_hz, "Hz") if watch else ""
        size = amount(watch.bytes_per_second, "B/s") if watch else ""
        message = watch.latest if watch else None
        return [
            _name(topic),
            _types(topic),
            str(len(topic.publishers)),
            str(len(topic.subscriptions)),
            rate,
            size,
            brief(message) if message is not None else "",
        ]

    # -- the details ---------------------------------------------------------------------------

    def choose(self, topic: str) -> None:
        """Show a topic's details, or no longer if they are shown."""
        if self.details is not None and self.frame.query.get("topic") == topic:
            self.close()
            return
        self.end_details()
        self.frame.set_query(topic=topic)
        self.frame.show_command(f"zbot topic echo {shlex.quote(topic)}")
        self.table.choose(topic)
        self.split.classes(add="zb-split-open")
        self.details = self.frame.part()
        with self.side:
            show_topic(self.details, topic, self.close)

    def close(self) -> None:
        """Show the list alone."""
        self.end_details()
        self.frame.set_query()
        self.frame.show_command("zbot topic list -t")
        self.table.choose(None)
        self.split.classes(remove="zb-split-open")

    def end_details(self) -> None:
        """Take away what is shown of a topic."""
        if self.details is not None:
            self.details.close()
        self.details = None
        self.side.clear()


def _name(topic: TopicRow) -> Cell:
    if topic.guess is not None:
        hint = f"nobody publishes {topic.name}: is {topic.guess} meant?"
        return Cell(topic.name, "zb-bad", hint=hint)
    return Cell(topic.name, hint=topic.name)


def _types(topic: TopicRow) -> Cell:
    text = ", ".join(topic.types)
    if topic.has_clash:
        return Cell(text, "zb-bad", hint=f"these types cannot hear each other: {text}")
    return Cell(text, hint=text)


def _build(frame: Frame) -> None:
    _Topics(frame)


PANEL = Panel("/topics", "Topics", "lan", _build)
