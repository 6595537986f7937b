"""Panel of the graph of nodes and topics, with its toolbar. It is drawn again at each change."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from nicegui import background_tasks, ui

from zbot.errors import counted
from zbot.graph.diagram import edge_key
from zbot.graph.dot import dot
from zbot.graph.view import Mode
from zbot.web.page.panel import Page, Panel
from zbot.web.page.service_call import DRAWING, run_in_thread
from zbot.web.panels.graph.graph_details import show_details
from zbot.web.panels.graph.graph_drawings import drawings_of
from zbot.web.panels.graph.graph_options import MOST_NAMESPACES, GraphOptions, filter_problem
from zbot.web.panels.graph.graph_rates import GraphRates

if TYPE_CHECKING:
    from zbot.graph.diagram import Drawing
    from zbot.graph.view import GraphView
    from zbot.web.page.panel import Section
    from zbot.web.panels.graph.graph_drawings import Drawn

# At this rate, a change is visible within 0.2 s, and a launch of many nodes needs few drawings.
_DRAW_HZ = 5.0
_RATE_HZ = 1.0
_CHOSEN = "chosen"
_RATES = "rates"
_MOST_PROBLEMS = 20
_MOST_LEFT_OUT = 100


_MODES = {Mode.NODES: "Nodes", Mode.ACTIVE: "Active", Mode.ALL: "All"}
_FILTER_HINT = "names or regular expressions, separated by commas; to leave names out: -/rqt.*"
#: Options of `zbot graph`. Each has its name, the text of its box (as in rqt_graph), a tooltip, and
#: whether a checked box sets the option (otherwise an unchecked box sets it).
_HIDE = (
    ("no-dead-sinks", "Dead sinks", "topics without subscriptions", True),
    ("no-leaf-topics", "Leaf topics", "topics with one connection", True),
    ("debug-topics", "Debug", "/rosout, /statistics, /clock; rqt and rviz", False),
    ("no-tf", "tf", "transforms", True),
    ("params", "Params", "/parameter_events", False),
    ("no-actions", "Actions", "", True),
    ("include-hidden", "Hidden", "names with a part that begins with _", False),
)
_GROUP = (
    ("no-group-actions", "Actions", "an action is one box", False),
    ("no-group-tf", "tf", "/tf and /tf_static are one box", False),
    ("no-group-images", "Images", "an image and its compressed forms are one box", False),
)


class GraphPanel:
    """Drawing of the graph, with its options and the details of a clicked item."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.options = GraphOptions.from_query(page.query)
        self._drawings = drawings_of(page.system)
        self._drawn: Drawn | None = None
        self._is_drawing = False
        self._fault: Exception | None = None
        self._wants_layout = self._has_own_layout = False
        self.rates = GraphRates(page)
        self.shows_rates = _RATES in page.query
        self._seen: tuple[int, GraphOptions] | None = None
        self._shown: tuple[Drawing, bool] | None = None
        self._chosen = ""
        self._details: Section | None = None
        _add_filters(self)
        _add_options_menu(self)
        _add_export_menu(self)
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

    @property
    def drawing(self) -> Drawing | None:
        """The drawing that the page shows, or None before the first one."""
        return None if self._drawn is None else self._drawn.drawing

    def update(self) -> None:
        """Draw the graph again if the graph or the options have changed."""
        if self._fault is not None:
            raise self._fault  # the page shows it
        state = (self.page.system.revision, self.options)
        if self._is_drawing or (state == self._seen and not self._wants_layout):
            return
        self._seen, self._is_drawing = state, True
        background_tasks.create(self._draw(), name="zbot graph")

    async def _draw(self) -> None:
        # The layout of a large graph takes a second, so a thread makes it.
        before = None if self._wants_layout else self._drawn
        self._wants_layout = False
        make = partial(self._drawings.draw, is_shared=not self._has_own_layout)
        try:
            self._drawn = await run_in_thread(make, self.options, before, threads=DRAWING)
            self._show_notes(self._drawn.view)
            await self._show()
        except Exception as error:  # noqa: BLE001 - see `update`
            self._fault = error
        finally:
            self._is_drawing = False

    def tidy(self) -> None:
        """Make a new layout, which does not keep the places of items. Other pages keep theirs."""
        self._wants_layout = self._has_own_layout = True

    def fit(self) -> None:
        """Show the whole drawing."""
        self.page.call("zbot.graph.fit", self._id)

    async def _show(self) -> None:
        if self.drawing is None or self._shown == (self.drawing, self.shows_rates):
            return
        self._shown = (self.drawing, self.shows_rates)
        svg = await self.svg()
        if self.shows_rates:
            self.rates.match(self.drawing.view)
        self.page.call("zbot.graph.show", self._id, svg, self._chosen)

    async def svg(self) -> str:
        """Return the drawing as SVG. It contains the rates if the page shows rates."""
        if self._drawn is None:
            return ""
        if not self.shows_rates:
            return self._drawn.svg
        drawing = self._drawn.drawing
        labels = self.rates.labels(drawing.view)
        return await run_in_thread(drawing.svg, labels, threads=DRAWING)

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
            for problem in view.problems[:_MOST_PROBLEMS]:
                ui.label(problem)
            more = len(view.problems) - _MOST_PROBLEMS
            if more > 0:
                ui.label(f"and {counted(more, 'more problem')}")
        self._problems.set_visibility(bool(view.problems))
        more = len(view.left_out) - _MOST_LEFT_OUT
        names = ", ".join(view.left_out[:_MOST_LEFT_OUT]) + (f" and {more} more" * (more > 0))
        self._left_out.set_text(f"not shown: {names}" if names else "")

    def change(self, options: GraphOptions) -> None:
        """Draw the graph with other options, and put the options into the address."""
        self.options = options
        self._has_own_layout = False
        self.remember()
        self.show_command()

    async def switch_rates(self, event: Any) -> None:
        """Start or stop showing rates."""
        self.shows_rates = bool(event.value)
        if not self.shows_rates:
            self.rates.match(None)
        self.remember()
        await self._show()

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


def _add_filters(panel: GraphPanel) -> None:
    """Add the modes, the two filters, and the switch for rates."""
    with panel.page.toolbar:

        def choose_mode(event: Any) -> None:
            panel.change(replace(panel.options, mode=Mode(event.value)))

        modes = {mode.value: text for mode, text in _MODES.items()}
        toggle = ui.toggle(modes, value=panel.options.mode.value, on_change=choose_mode)
        toggle.props('dense unelevated no-caps aria-label="Topics"').classes("zb-graph-modes")
        _add_filter(panel, "nodes", "Nodes")
        _add_filter(panel, "topics", "Topics")
        rates = ui.switch("Rates", value=panel.shows_rates, on_change=panel.switch_rates)
        rates.props("dense").tooltip("Messages a second; the page subscribes to all shown topics")


def _add_filter(panel: GraphPanel, name: str, label: str) -> None:
    value = getattr(panel.options.filters, name)

    def search(event: Any) -> None:
        text = event.value or "/"
        if filter_problem(text) is None:
            panel.change(panel.options.filtered(name, text))

    field = ui.input(
        placeholder=f"{label}: all",
        value="" if value == "/" else value,
        on_change=search,
        validation=filter_problem,
    )
    field.props(f'dense outlined clearable hide-bottom-space debounce=150 aria-label="{label}"')
    field.classes("zb-graph-filter").tooltip(_FILTER_HINT)


def _add_options_menu(panel: GraphPanel) -> None:
    """Add the menu with the options to hide and to group topics."""
    with (
        panel.page.toolbar,
        _button("tune", "Hide and group"),
        ui.menu().props("auto-close=false"),
        ui.element("div").classes("zb-graph-menu"),
    ):
        with ui.element("div").classes("zb-col"):
            ui.label("Hide").classes("zb-heading")
            for flag, text, hint, is_set in _HIDE:
                _add_tick(panel, flag, text, hint, when_set=is_set)
        with ui.element("div").classes("zb-col"):
            ui.label("Group").classes("zb-heading")
            _add_namespaces(panel)
            for flag, text, hint, is_set in _GROUP:
                _add_tick(panel, flag, text, hint, when_set=is_set)


def _add_tick(panel: GraphPanel, flag: str, text: str, hint: str, *, when_set: bool) -> None:
    def tick(event: Any) -> None:
        panel.change(panel.options.flagged(flag, is_set=bool(event.value) is when_set))

    box = ui.checkbox(text, value=panel.options.has(flag) is when_set, on_change=tick)
    box.props("dense").classes("zb-graph-tick")
    if hint:
        box.tooltip(hint)


def _add_namespaces(panel: GraphPanel) -> None:
    def set_levels(event: Any) -> None:
        if event.value is not None and 0 <= event.value <= MOST_NAMESPACES:
            panel.change(panel.options.framed(int(event.value)))

    with ui.element("div").classes("zb-row"):
        levels = panel.options.grouping.namespaces
        field = ui.number(value=levels, min=0, max=MOST_NAMESPACES, step=1, on_change=set_levels)
        field.props('dense outlined aria-label="Levels of namespaces"').classes("zb-graph-levels")
        ui.label("namespaces")


def _add_export_menu(panel: GraphPanel) -> None:
    """Add the buttons that make a new layout, show the whole graph, and save the graph."""
    with panel.page.toolbar:
        _button("auto_fix_high", "Tidy up").on_click(panel.tidy)
        _button("fit_screen", "Show all").on_click(panel.fit)
        with _button("download", "Save"), ui.menu():
            ui.menu_item("SVG", lambda: _save_svg(panel))
            ui.menu_item("PNG", lambda: _save_png(panel))
            ui.menu_item("DOT", lambda: _save_dot(panel))


def _button(icon: str, text: str) -> ui.button:
    button = ui.button(icon=icon).props(f'flat round dense aria-label="{text}"')
    return button.tooltip(text)


async def _save_svg(panel: GraphPanel) -> None:
    panel.page.call("zbot.save", "graph.svg", await panel.svg(), "image/svg+xml")
    panel.page.show_command(f"{panel.options.command} --svg graph.svg")


async def _save_png(panel: GraphPanel) -> None:
    panel.page.call("zbot.graph.savePng", "graph.png", await panel.svg())
    panel.page.show_command(f"{panel.options.command} --svg graph.svg")


def _save_dot(panel: GraphPanel) -> None:
    if panel.drawing is not None:
        text = dot(panel.drawing.view) + "\n"
        panel.page.call("zbot.save", "graph.dot", text, "text/vnd.graphviz")
        panel.page.show_command(f"{panel.options.command} --dot > graph.dot")


def _build(page: Page) -> None:
    GraphPanel(page)


PANEL = Panel("/graph", "Graph", "hub", _build)
