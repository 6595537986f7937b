"""Toolbar above the graph, with mode, filters, options to hide and group, and export."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.graph.dot import dot
from zbot.graph.view import Mode
from zbot.web.panels.graph.graph_options import MOST_NAMESPACES, filter_problem

if TYPE_CHECKING:
    from zbot.web.panels.graph.panel import GraphPanel

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


def add_filters(panel: GraphPanel) -> None:
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


def add_options_menu(panel: GraphPanel) -> None:
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


def add_export_menu(panel: GraphPanel) -> None:
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


def _save_svg(panel: GraphPanel) -> None:
    panel.page.call("zbot.save", "graph.svg", panel.svg(), "image/svg+xml")
    panel.page.show_command(f"{panel.options.command} --svg graph.svg")


def _save_png(panel: GraphPanel) -> None:
    panel.page.call("zbot.graph.savePng", "graph.png", panel.svg())
    panel.page.show_command(f"{panel.options.command} --svg graph.svg")


def _save_dot(panel: GraphPanel) -> None:
    if panel.drawing is not None:
        text = dot(panel.drawing.view) + "\n"
        panel.page.call("zbot.save", "graph.dot", text, "text/vnd.graphviz")
        panel.page.show_command(f"{panel.options.command} --dot > graph.dot")
