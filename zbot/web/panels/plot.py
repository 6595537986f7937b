"""Panel of a plot, which shows numeric fields of topics over time."""

from __future__ import annotations

import shlex
import time
from functools import partial
from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.errors import ZbotError
from zbot.interfaces import get_message
from zbot.interfaces.registry import find_spec
from zbot.observer.curve import Curves, curve_tree, numeric_fields, split_curve
from zbot.observer.value_text import number
from zbot.web.page.panel import Page, Panel

if TYPE_CHECKING:
    from zbot.observer.watch import Watch

_WINDOWS_S = {5: "5 s", 10: "10 s", 30: "30 s", 60: "1 min", 300: "5 min"}
_DEFAULT_WINDOW_S = 10
#: Seconds between movements of the time axis. The axis also moves between messages of a slow topic.
_SCROLL_S = 0.1
_LEGEND_HZ = 4.0
_COLOURS = 6
_OVER_TIME = "over time"


class _Watcher:
    """Watcher of topics for a page. It also works while the page is hidden: curves have no gaps."""

    def __init__(self, page: Page) -> None:
        self._page = page

    def watch(self, topic: str, *, keep: int) -> Watch:
        return self._page.watch(topic, keep=keep, even_hidden=True)


class _Plot:
    def __init__(self, page: Page) -> None:
        self.page = page
        self.curves = Curves(_Watcher(page))
        self.window_s = _DEFAULT_WINDOW_S
        self.paused = False
        self.sent: list[str] = []
        self.listed: list[str] = []
        self.known: dict[str, list[str] | None] = {}  # the fields of each type
        self.values: dict[str, ui.label] = {}
        self.rows: dict[str, ui.element] = {}
        self.dots: dict[str, ui.element] = {}
        self.sides: dict[str, ui.button] = {}
        # The names of the curves with the axis on the right, and of the curve on the x axis.
        self.right = set(filter(None, page.query.get("right", "").split(",")))
        self.over = page.query.get("over", "")
        self.moved_s = 0.0
        self.came_s = 0.0
        self.add_toolbar()
        with ui.element("div").classes("zb-fill"):
            self.legend = ui.element("div").classes("zb-legend")
            with self.legend:
                hint = "Type a topic and a field, e.g. /turtle1/pose.x"
                self.hint = ui.label(hint).classes("zb-muted")
            with ui.element("div").classes("zb-card zb-plot"):
                self.chart = ui.echart({}, renderer="svg").classes("zb-chart")
        page.call("zbot.plot.start", self.chart.id, self.window_s)
        page.call("zbot.plot.setAxes", self.chart.id, sorted(self.right), self.over)
        for word in filter(None, page.query.get("curve", "").split(",")):
            self.add(word)
        self.show_state()
        page.live(self.draw)
        page.live(self.update_legend, _LEGEND_HZ)

    def add_toolbar(self) -> None:
        """Add the input for curves, the choice of the shown time span, and the buttons."""
        with self.page.toolbar:
            self.entry = ui.input(placeholder="/topic.field", autocomplete=self.proposals())
            self.entry.props('dense outlined aria-label="Curve"').classes("zb-curve-entry")
            # The text comes with the key: while the page connects, the key may overtake the text.
            self.entry.on(
                "keydown.enter",
                lambda event: self.add_typed(event.args),
                js_handler="(event) => emit(event.target.value)",
            )
            self.entry.on("focus", lambda: self.entry.set_autocomplete(self.proposals()))
            add = ui.button("Add", icon="add", on_click=lambda: self.add_typed(self.entry.value))
            add.props("unelevated dense")
            self.add_tree()
            over = ui.select([_OVER_TIME], value=_OVER_TIME, on_change=self.change_over)
            over.props('dense outlined options-dense aria-label="X axis"').classes("zb-over")
            self.over_choice = over
            choice = ui.select(_WINDOWS_S, value=self.window_s, on_change=self.change_window)
            choice.props('dense outlined aria-label="Window"').classes("zb-window")
            self.pause = ui.button("Pause", icon="pause", on_click=self.toggle_pause)
            self.pause.props("outline dense")
            for text, icon, function in (
                ("Clear", "delete_sweep", "zbot.plot.clear"),
                ("CSV", "download", "zbot.plot.save"),
            ):
                button = ui.button(text, icon=icon).props("outline dense")
                button.on_click(lambda _, name=function: self.page.call(name, self.chart.id))

    def add_tree(self) -> None:
        """Add the button that shows all topics and fields as a tree with boxes to tick."""
        button = ui.button("Fields", icon="account_tree").props("outline dense")
        with button, ui.menu().classes("zb-fields") as menu:
            search = ui.input(placeholder="Filter").props('dense outlined aria-label="Filter"')
            self.tree = ui.tree([], tick_strategy="leaf", on_tick=self.tick)
            self.tree.props("dense no-transition")
            search.bind_value_to(self.tree, "filter")
        menu.props("no-refocus")
        menu.on("before-show", self.fill_tree)

    def fill_tree(self) -> None:
        """Show the present topics and fields, with a tick at each curve."""
        self.tree.props["nodes"] = curve_tree(self.fields())
        self.tree.props["ticked"] = self.names()
        self.tree.update()

    def tick(self, event: Any) -> None:
        """Add the curves that got a tick, and remove the curves that lost it."""
        ticked, names = set(event.value), set(self.names())
        if ticked == names:
            return
        in_tree = {f"{topic}.{path}" for topic, paths in self.fields().items() for path in paths}
        for name in names & in_tree - ticked:
            self.curves.remove(name)
        for name in sorted(ticked - names):
            self.add(name)
        self.show_state()

    def fields(self) -> dict[str, list[str]]:
        """Return the paths of each topic's numbers, without elements of arrays of variable size."""
        found = {}
        for topic, types in self.page.system.snapshot().topics():
            fields = self.fields_of(types[0])
            if fields is not None:
                found[topic] = fields
        return found

    def fields_of(self, type_name: str) -> list[str] | None:
        """Return the paths of a type's numbers, or None without a right definition on this machine.

        The user can type a field's name nevertheless.
        """
        if type_name not in self.known:
            try:
                if find_spec(type_name) is None:
                    return None  # this machine may learn the type later
                self.known[type_name] = numeric_fields(get_message(type_name)())
            except ZbotError:
                self.known[type_name] = None
        return self.known[type_name]

    def names(self) -> list[str]:
        """Return the names of the curves, and the topics whose first message has not come."""
        return [*(curve.name for curve in self.curves.curves), *self.curves.waiting]

    def proposals(self) -> list[str]:
        """Return the names of curves that the user can add now."""
        return [f"{topic}.{path}" for topic, paths in self.fields().items() for path in paths]

    def add_typed(self, text: Any) -> None:
        """Add the curve that the user typed in the toolbar."""
        if self.add(str(text or "")):
            self.entry.set_value("")
            self.show_state()

    def add(self, word: str) -> bool:
        """Add a curve. Return False if the text is not the name of a curve."""
        topics = [name for name, _ in self.page.system.snapshot().topics()]
        try:
            self.curves.add(*split_curve(word, topics))
        except ZbotError as error:
            ui.notify(str(error), type="negative")
            return False
        return True

    def remove(self, name: str) -> None:
        self.curves.remove(name)
        self.show_state()

    def show_state(self) -> None:
        """Show the command that plots the same curves. Put the curves into the page's address."""
        names = self.names()
        self.page.show_command(shlex.join(["zbot", "plot", *names]))
        words = {
            "curve": ",".join(names),
            "right": ",".join(name for name in names if name in self.right),
            "over": self.over if self.over in names else "",
        }
        query = {key: word for key, word in words.items() if word}
        if query != self.page.query:
            self.page.set_query(**query)

    def change_window(self, event: Any) -> None:
        self.window_s = event.value
        self.page.call("zbot.plot.setWindow", self.chart.id, self.window_s)

    def change_over(self, event: Any) -> None:
        """Draw the curves over the time, or over the values of one curve."""
        chosen = "" if event.value == _OVER_TIME else event.value.removeprefix("over ")
        if chosen != self.over:
            self.over = chosen
            self.show_axes()

    def switch_side(self, name: str) -> None:
        """Move a curve to the axis on the other side."""
        self.right ^= {name}
        self.show_axes()

    def show_axes(self) -> None:
        for name, button in self.sides.items():
            button.set_text("right" if name in self.right else "left")
        self.page.call("zbot.plot.setAxes", self.chart.id, sorted(self.right), self.over)
        self.show_state()

    def toggle_pause(self) -> None:
        """Stop or continue the movement of the plot. Points are collected in both states."""
        self.paused = not self.paused
        self.pause.set_text("Resume" if self.paused else "Pause")
        self.pause.set_icon("play_arrow" if self.paused else "pause")
        self.page.call("zbot.plot.setPaused", self.chart.id, self.paused)

    def draw(self) -> None:
        points = self.curves.take()
        names = [curve.name for curve in self.curves.curves]
        if names != self.sent:
            self.sent = names
            self.page.call("zbot.plot.setCurves", self.chart.id, names)
            self.show_state()
        now_s = time.time()
        if points:
            self.came_s = now_s
        is_moving = now_s - self.came_s < self.window_s and now_s - self.moved_s >= _SCROLL_S
        if points or is_moving:
            self.moved_s = now_s
            self.page.call("zbot.plot.add", self.chart.id, points, now_s)

    def update_legend(self) -> None:
        """Show each curve's newest value, or the reason why it has no value."""
        names = self.names()
        if names != self.listed:
            self.listed = names
            self.fill_legend(names)
            self.fill_over(names)
        for curve in self.curves.curves:
            problem = self.curves.problem(curve)
            label = self.values[curve.name]
            label.set_text(problem or ("" if curve.last is None else number(curve.last)))
            label.classes(replace="zb-warn" if problem else "zb-mono")

    def fill_legend(self, names: list[str]) -> None:
        """List the curves. A curve keeps its row until its removal, so that no click is lost."""
        for name in [name for name in self.rows if name not in names]:
            self.rows.pop(name).delete()
            del self.values[name], self.dots[name], self.sides[name]
        for index, name in enumerate(names):
            if name not in self.rows:
                self.add_row(name)
            if self.legend.default_slot.children[index] is not self.rows[name]:
                self.rows[name].move(target_index=index)
            self.dots[name].style(f"background: var(--zb-curve-{index % _COLOURS + 1})")
            if name in self.curves.waiting:
                self.values[name].set_text("no node uses it yet")
        self.hint.set_visibility(not names)

    def fill_over(self, names: list[str]) -> None:
        """Offer the curves as x axis. The time is chosen again when the chosen curve is removed."""
        value = f"over {self.over}" if self.over in names else _OVER_TIME
        self.over_choice.set_options([_OVER_TIME, *(f"over {name}" for name in names)], value=value)

    def add_row(self, name: str) -> None:
        with self.legend, ui.element("div").classes("zb-legend-item") as row:
            self.dots[name] = ui.element("span").classes("zb-dot")
            ui.label(name).classes("zb-mono")
            self.values[name] = ui.label("")
            side = ui.button("right" if name in self.right else "left")
            side.on_click(partial(self.switch_side, name))
            side.props("flat dense size=sm color=grey-6")
            side.props["aria-label"] = f"Axis of {name}"  # a quote in the name stays a quote
            self.sides[name] = side
            button = ui.button(icon="close", on_click=partial(self.remove, name))
            button.props("flat round dense size=xs color=grey-6")
            button.props["aria-label"] = f"Remove {name}"
        self.rows[name] = row


def _build(page: Page) -> None:
    _Plot(page)


PANEL = Panel("/plot", "Plot", "show_chart", _build)
