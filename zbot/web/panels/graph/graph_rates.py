"""Rates in messages a second, which the graph shows beside its arrows."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.graph.topics import BoxKind
from zbot.observer.value_text import amount

if TYPE_CHECKING:
    from zbot.graph.view import Edge, GraphView
    from zbot.observer.watch import Watch
    from zbot.web.page.panel import Section

#: The largest number of topics with a rate, because each of them needs a subscription. Users can
#: choose topics with a filter.
MOST_WATCHED = 300


class GraphRates:
    """Watches of the topics in the drawing.

    Args:
        section: The section of the panel. When it is closed, the watches end.
    """

    def __init__(self, section: Section) -> None:
        self._section = section
        self._watches: dict[str, Watch] = {}

    def match(self, shown: GraphView | None) -> None:
        """Watch exactly the topics of a view, or no topics if the view is None."""
        topics = shown.topics if shown is not None else ()
        names = [topic.name for topic in topics if topic.kind is BoxKind.TOPIC][:MOST_WATCHED]
        for name in self._watches.keys() - set(names):
            self._section.drop(self._watches.pop(name))
        for name in names:
            if name not in self._watches:
                self._watches[name] = self._section.watch(name)

    def labels(self, shown: GraphView) -> dict[Edge, str]:
        """Return the text beside each arrow.

        The rate of a topic is the sum of the rates of its publishers. If there are several
        publishers, the rate is only beside the arrows to subscriptions.
        """
        alone = {topic.name: len(topic.publishers) == 1 for topic in shown.topics}
        found = {}
        for edge in shown.edges:
            watch = self._watches.get(edge.topic) if edge.kind is BoxKind.TOPIC else None
            is_one_s = alone[edge.topic] or not (edge.is_publishing or edge.label)
            if watch is not None and watch.count and is_one_s and not edge.is_wrong:
                found[edge] = amount(watch.rate_hz, "Hz")
        return found
