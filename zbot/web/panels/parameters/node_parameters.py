"""Inputs for the parameters of one node, which follow the values that other programs set."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.errors import ZbotError
from zbot.parameters.parameter import (
    UnknownParameterTypeError,
    parameter_type,
    parameter_value_to_python,
)
from zbot.threads.deadline import Deadline
from zbot.web.page.command_line import command_line
from zbot.web.page.service_call import run_in_thread
from zbot.web.panels.parameters.described_parameter import load
from zbot.web.panels.parameters.parameter_input import ParameterInput
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from zbot.web.page.panel import Section
    from zbot.web.panels.parameters.described_parameter import DescribedParameter

_EVENTS = "/parameter_events"
_EVENTS_KEPT = 200
_LIVE_HZ = 15.0
#: Longest time to read events at once. More would stop the other pages.
_READ_S = 0.01
# Shortest time between two loads. A program may publish thousands of events with new parameters.
_LOAD_PAUSE_S = 1.0
#: Names of parameters that every node has. They are shown last.
_EVERY_NODE_HAS = ("start_type_description_service", "use_sim_time", "qos_overrides.")


class NodeParameters:
    """Inputs for the parameters of a node. The constructor adds them to the current element.

    Args:
        section: The section of the page.
        node: The node's full name.
        prefix: Only parameters whose names begin with this text are shown, without it.
        beside: Function that returns a text for a value, which is shown beside it.
        empty: What is shown if there is no parameter.
    """

    def __init__(
        self,
        section: Section,
        node: str,
        *,
        prefix: str = "",
        beside: Callable[[DescribedParameter, Any], str] | None = None,
        empty: str = "This node has no parameters.",
    ) -> None:
        self.section, self.node = section, node
        self.prefix, self.beside, self.empty = prefix, beside, empty
        self.inputs: dict[str, ParameterInput] = {}
        self.watch = section.watch(_EVENTS, "rcl_interfaces/msg/ParameterEvent", keep=_EVENTS_KEPT)
        self.last = 0
        self.server: frozenset[str] = frozenset()
        self.is_stale = self.is_loading = False
        self.load_pause = Deadline(0)
        with ui.element("div") as self.frame:
            self.place = ui.element("div").classes("zb-parameters")
        section.page.show_command(command_line("param", "dump", node))
        self.load()
        section.live(self.update, _LIVE_HZ)

    @property
    def names(self) -> list[str]:
        """The names of the shown parameters, without the prefix."""
        return [name.removeprefix(self.prefix) for name in self.inputs]

    def load(self) -> None:
        """Load all parameters again, in the background."""
        self.is_stale, self.is_loading = False, True
        self.load_pause = Deadline(_LOAD_PAUSE_S)
        # Events before the load may be those of a former node of this name.
        self.last = self.watch.count
        self.server = self.read_server()
        with self.frame:  # not `place`, whose `clear` would cancel the load
            ui.timer(0, self.fill, once=True)

    async def fill(self) -> None:
        """Load all parameters, and show them or an error."""
        try:
            await self.show_all()
        finally:
            self.is_loading = False

    async def show_all(self) -> None:
        """Show all parameters, or why they cannot be read."""
        try:
            found = await run_in_thread(
                load, self.section.system.parameters, self.node, self.prefix
            )
        except ZbotError as error:
            self.inputs = {}
            self.place.clear()
            with self.place:
                ui.label(str(error)).classes("zb-bad")
            return
        # The node's own parameters come first.
        found.sort(
            key=lambda parameter: (parameter.name.startswith(_EVERY_NODE_HAS), parameter.name)
        )
        self.inputs = {}
        self.place.clear()
        with self.place:
            for parameter in found:
                self.inputs[parameter.name] = ParameterInput(
                    self.section,
                    self.node,
                    parameter,
                    label=parameter.name.removeprefix(self.prefix),
                    beside=self.beside,
                )
                # Other pages go on: a row takes some milliseconds, and a node may have 300.
                await asyncio.sleep(0)
            if not found:
                ui.label(self.empty).classes("zb-muted")

    def update(self) -> None:
        """Show the values of new events, or load all parameters again.

        They are loaded again if there are new or deleted parameters, if an event was missed, if
        `follow` returns False, or if the node was started again. Events during a load are shown
        after it.
        """
        if self.is_loading:
            return
        changed: dict[str, Any] = {}
        for record, event in self.watch.read_since(self.last, Deadline(_READ_S)):
            # Events are left out if they come too fast, or if they are too large.
            self.is_stale |= record.number > self.last + 1
            self.last = record.number
            if event is not None and event.node == self.node:
                self.is_stale |= bool(event.new_parameters or event.deleted_parameters)
                changed |= {message.name: message.value for message in event.changed_parameters}
        self.is_stale |= not self.follow(changed)
        server = self.read_server()
        self.is_stale |= bool(server) and server != self.server
        if self.is_stale and self.load_pause.is_over:
            self.load()

    def read_server(self) -> frozenset[str]:
        """Return what is different after a new start of the node; empty while it does not run."""
        graph = self.section.system.snapshot()
        servers = graph.on(f"{self.node}/set_parameters_atomically", EntityKind.SERVICE)
        return frozenset(token.key for token in servers)

    def follow(self, changed: Mapping[str, Any]) -> bool:
        """Show new values by name. Return False if a value needs another kind of input."""
        is_complete = True
        for name, value in changed.items():
            known = self.inputs.get(name)
            try:
                kind = parameter_type(value.type)
                shown = known is None or known.show(kind, parameter_value_to_python(value))
            except UnknownParameterTypeError:
                shown = False
            is_complete &= shown
        return is_complete
