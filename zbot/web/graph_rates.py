"""Messages a second beside the arrows of the graph, while somebody wants to see them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.graph.topics import BoxKind
from zbot.web.value_text import amount

if TYPE_CHECKING:
    from zbot.graph.view import Edge, GraphView
    from zbot.web.panel import Part
    from zbot.web.watch import Watch

#: Measuring means to receive. Whoever has more topics finds theirs by the filter.
MOST_WATCHED = 300


class GraphRates:
    """Watches the topics of a picture.

    Args:
        part: Ends with it.
    """

    def __init__(self, part: Part) -> None:
        self._part = part
        self._watches: dict[str, Watch] = {}

    def match(self, shown: GraphView | None) -> None:
        """Watch the topics that are shown and no others; None: none at all."""
        topics = shown.topics if shown is not None else ()
        names = [topic.name for topic in topics if topic.kind is BoxKind.TOPIC][:MOST_WATCHED]
        for name in self._watches.keys() - set(names):
            self._part.drop(self._watches.pop(name))
        for name in names:
            if name not in self._watches:
                self._watches[name] = self._part.watch(name)

    def labels(self, shown: GraphView) -> dict[Edge, str]:
        """Return what stands beside each arrow.

        What several nodes publish is measured together: it stands beside the arrows that lead to
        who hears it, not beside those that lead to the topic.
        """
        alone = {one.name: len(one.publishers) == 1 for one in shown.topics}
        found = {}
        for edge in shown.edges:
            watch = self._watches.get(edge.topic) if edge.kind is BoxKind.TOPIC else None
            is_one_s = alone[edge.topic] or not (edge.is_publishing or edge.label)
            if watch is not None and watch.count and is_one_s and not edge.is_wrong:
                found[edge] = amount(watch.rate_hz, "Hz")
        return found
