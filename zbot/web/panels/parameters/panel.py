"""Panel of one node's parameters. Each parameter has an input for its type and range."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.errors import ZbotError
from zbot.parameters.parameter import (
    UnknownParameterTypeError,
    parameter_type,
    parameter_value_to_python,
)
from zbot.remote.parameters import nodes_with_parameters
from zbot.threads.deadline import Deadline
from zbot.web.page.command_line import command_line
from zbot.web.page.list_panel import ListPanel
from zbot.web.page.panel import Page, Panel
from zbot.web.page.service_call import run_in_thread
from zbot.web.page.table import Cell, Column
from zbot.web.panels.parameters.described_parameter import load
from zbot.web.panels.parameters.parameter_input import ParameterInput

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot
    from zbot.web.page.panel import Section

_EVENTS = "/parameter_events"
_EVENTS_KEPT = 200
_LIVE_HZ = 15.0
# Shortest time between two loads. A program may publish thousands of events with new parameters.
_LOAD_PAUSE_S = 1.0
#: Names of parameters that every node has. The panel shows these parameters last.
_EVERY_NODE_HAS = ("start_type_description_service", "use_sim_time", "qos_overrides.")


def _build(page: Page) -> None:
    ListPanel(
        page,
        columns=(Column("Node", "zb-mono zb-cut"),),
        rows=_rows,
        details=_NodeParameters,
        key="node",
        command="zbot param list",
        empty="No node with parameters yet: start one, e.g. zbot run parameter_demo",
        hidden="Hidden nodes",
        is_narrow=True,
    )


def _rows(graph: Snapshot, hidden: bool) -> dict[str, list[str | Cell]]:
    nodes = nodes_with_parameters(graph, include_hidden=hidden)
    return {node: [Cell(node, hint=node)] for node in nodes}


class _NodeParameters:
    def __init__(self, section: Section, node: str) -> None:
        self.section, self.node = section, node
        self.inputs: dict[str, ParameterInput] = {}
        self.watch = section.watch(_EVENTS, "rcl_interfaces/msg/ParameterEvent", keep=_EVENTS_KEPT)
        self.last = 0
        self.is_stale = self.is_loading = False
        self.load_pause = Deadline(0)
        self.place = ui.element("div").classes("zb-parameters")
        section.page.show_command(command_line("param", "dump", node))
        self.load()
        section.live(self.update, _LIVE_HZ)

    def load(self) -> None:
        """Load all parameters again, in the background."""
        self.is_stale, self.is_loading = False, True
        self.load_pause = Deadline(_LOAD_PAUSE_S)
        with self.place:
            ui.timer(0, self.fill, once=True)

    async def fill(self) -> None:
        try:
            await self.show_all()
        finally:
            self.is_loading = False

    async def show_all(self) -> None:
        try:
            found = await run_in_thread(load, self.section.system.parameters, self.node)
        except ZbotError as error:
            self.inputs = {}
            self.place.clear()
            with self.place:
                ui.label(str(error)).classes("zb-bad")
            return
        # The node's own parameters come first.
        found.sort(key=lambda one: (one.name.startswith(_EVERY_NODE_HAS), one.name))
        self.place.clear()
        with self.place:
            self.inputs = {one.name: ParameterInput(self.section, self.node, one) for one in found}
            if not found:
                ui.label("This node has no parameters.").classes("zb-muted")

    def update(self) -> None:
        """Show the values of new events. If `follow` returns False, load all parameters again."""
        for record in self.watch.since(self.last):
            self.last = record.number
            event = self.watch.read(record)
            if event is not None and event.node == self.node:
                self.is_stale |= not self.follow(event)
        if self.is_stale and not self.is_loading and self.load_pause.is_over:
            self.load()

    def follow(self, event: Any) -> bool:
        """Show an event's values. Return False if a parameter is new, deleted or of a new type."""
        is_complete = not (event.new_parameters or event.deleted_parameters)
        for message in event.changed_parameters:
            known = self.inputs.get(message.name)
            try:
                kind, value = parameter_type(message.value.type), message.value
                shown = known is None or known.show(kind, parameter_value_to_python(value))
            except UnknownParameterTypeError:
                shown = False
            is_complete &= shown
        return is_complete


PANEL = Panel("/parameters", "Parameters", "tune", _build)
