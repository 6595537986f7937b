"""Drawings of the graph. Pages with the same options share them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary, WeakValueDictionary

from zbot.graph.diagram import Drawing, draw
from zbot.graph.view import limited

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.graph.snapshot import Snapshot
    from zbot.graph.view import GraphView
    from zbot.observer.system import System
    from zbot.web.panels.graph.graph_options import GraphOptions


@dataclass(frozen=True, eq=False)
class Drawn:
    """Drawing of a graph."""

    graph: Snapshot
    view: GraphView  #: as `drawing.view`, with the names that are left out now
    drawing: Drawing
    svg: str  #: without rates


class GraphDrawings:
    """Drawings of a graph. Only the one thread of `DRAWING` may call `draw`.

    Args:
        graph: Returns the graph as it is now. Until the next change, it returns the same object.
    """

    def __init__(self, graph: Callable[[], Snapshot]) -> None:
        self._graph = graph
        # A drawing is shared as long as a page shows it. The layout of the next page is new.
        self._shared: WeakValueDictionary[GraphOptions, Drawn] = WeakValueDictionary()

    def draw(self, options: GraphOptions, before: Drawn | None, *, is_shared: bool = True) -> Drawn:
        """Return a drawing of the graph as it is now.

        Args:
            options: What is drawn.
            before: The former drawing of the page. If possible, nodes and topics keep its places,
                or those of the shared drawing.
            is_shared: Whether to use the drawing of other pages, and to share the new one.
        """
        graph = self._graph()
        known = self._shared.get(options) if is_shared else None
        if known is not None and known.graph is graph:
            return known
        made = _drawn(graph, options, known or before)
        if is_shared:
            self._shared[options] = made
        return made


def _drawn(graph: Snapshot, options: GraphOptions, before: Drawn | None) -> Drawn:
    view = limited(options.view(graph))
    if before is None:
        drawing = draw(view)
    elif before.drawing.view == view:
        return Drawn(graph, view, before.drawing, before.svg)
    else:
        drawing = draw(view, before.drawing)
    return Drawn(graph, view, drawing, drawing.svg())


_DRAWINGS: WeakKeyDictionary[System, GraphDrawings] = WeakKeyDictionary()


def drawings_of(system: System) -> GraphDrawings:
    """Return the drawings of a system's graph."""
    found = _DRAWINGS.get(system)
    if found is None:
        found = _DRAWINGS[system] = GraphDrawings(system.snapshot)
    return found
