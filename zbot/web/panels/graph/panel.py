"""Panel of the graph of nodes and topics, which is drawn again at each change."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.graph.diagram import draw, edge_key
from zbot.web.page.panel import Page, Panel
from zbot.web.panels.graph.graph_details import show_details
from zbot.web.panels.graph.graph_menu import add_export_menu, add_filters, add_options_menu
from zbot.web.panels.graph.graph_options import GraphOptions
from zbot.web.panels.graph.graph_rates import GraphRates

if TYPE_CHECKING:
    from zbot.graph.diagram import Drawing
    from zbot.graph.view import GraphView
    from zbot.web.page.panel import Section

# At this rate, a change is visible within 0.2 s, and a launch of many nodes needs few drawings.
_DRAW_HZ = 5.0
_RATE_HZ = 1.0
_CHOSEN = "chosen"
_RATES = "rates"


class GraphPanel:
    """Drawing of the graph, with its options and the details of a clicked item."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.options = GraphOptions.from_query(page.query)
        self.drawing: Drawing | None = None
        self.rates = GraphRates(page)
        self.shows_rates = _RATES in page.query
        self._seen: tuple[int, GraphOptions] | None = None
        self._chosen = ""
        self._details: Section | None = None
        add_filters(self)
        add_options_menu(self)
        add_export_menu(self)
        with ui.element("div").classes("zb-split zb-graph-split") as self._split:
            with ui.element("div").classes("zb-card zb-graph-card"):
                self._canvas = ui.element("div").classes("zb-graph")
                self._problems = ui.element("div").classes("zb-graph-problems")
                self._left_out = ui.label().classes("zb-graph-left-out zb-muted")
            self._side = ui.element("div").classes("zb-card zb-side")
        self._id = self._canvas.html_id
        page.on_choose(self._id, self.choose)
        page.live(self.update, _DRAW_HZ)
        page.live(self.update_rates, _RATE_HZ)
        self.choose(page.query.get(_CHOSEN, ""))

    def update(self) -> None:
        """Draw the graph again if the graph or the options have changed."""
        state = (self.page.system.revision, self.options)
        if state == self._seen:
            return
        self._seen = state
        view = self.options.view(self.page.system.snapshot())
        self._show_notes(view)
        if self.drawing is None or self.drawing.view != view:
            self.drawing = draw(view, self.drawing)
            self._show()

    def tidy(self) -> None:
        """Make a new layout, which does not keep the places of items."""
        if self.drawing is not None:
            self.drawing = draw(self.drawing.view)
            self._show()

    def fit(self) -> None:
        """Show the whole drawing."""
        self.page.call("zbot.graph.fit", self._id)

    def _show(self) -> None:
        if self.drawing is not None:
            if self.shows_rates:
                self.rates.match(self.drawing.view)
            self.page.call("zbot.graph.show", self._id, self.svg(), self._chosen)

    def svg(self) -> str:
        """Return the drawing as SVG. It contains the rates if the page shows rates."""
        if self.drawing is None:
            return ""
        labels = self.rates.labels(self.drawing.view) if self.shows_rates else None
        return self.drawing.svg(labels)

    def update_rates(self) -> None:
        """Write the rates beside the arrows."""
        if self.shows_rates and self.drawing is not None:
            labels = self.rates.labels(self.drawing.view)
            texts = {edge_key(edge): text for edge, text in labels.items()}
            self.page.call("zbot.graph.showRates", self._id, texts)

    def _show_notes(self, view: GraphView) -> None:
        """Show the problems, and the names that the drawing leaves out."""
        self._problems.clear()
        with self._problems:
            for problem in view.problems:
                ui.label(problem)
        self._problems.set_visibility(bool(view.problems))
        names = ", ".join(view.left_out)
        self._left_out.set_text(f"not shown: {names}" if names else "")

    def change(self, options: GraphOptions) -> None:
        """Draw the graph with other options, and put the options into the address."""
        self.options = options
        self.remember()
        self.show_command()

    def switch_rates(self, event: Any) -> None:
        """Start or stop showing rates."""
        self.shows_rates = bool(event.value)
        if not self.shows_rates:
            self.rates.match(None)
        self._show()
        self.remember()

    def remember(self) -> None:
        """Put the options, the switch for rates and the chosen item into the address."""
        query = self.options.query
        query |= {_RATES: "1"} if self.shows_rates else {}
        query |= {_CHOSEN: self._chosen} if self._chosen else {}
        self.page.set_query(**query)

    def show_command(self) -> None:
        """Show the command that prints this page's graph."""
        self.page.show_command(self.options.command)

    def choose(self, key: str) -> None:
        """Show the details of a node, topic or action. Close them if the key is empty."""
        if self._details is not None:
            self._details.close()
            self._details = None
        self._side.clear()
        self._chosen = ""
        if key:
            self._details = self.page.section()
            with self._side:
                command = show_details(self._details, key, lambda: self.choose(""))
            if command:
                self._chosen = key
                self.page.show_command(command)
        if self._chosen:
            self._split.classes(add="zb-split-open")
        else:
            self._split.classes(remove="zb-split-open")
            self.show_command()
        self.page.call("zbot.graph.choose", self._id, self._chosen)
        self.remember()


def _build(page: Page) -> None:
    GraphPanel(page)


PANEL = Panel("/graph", "Graph", "hub", _build)
