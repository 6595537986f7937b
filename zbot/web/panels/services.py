"""Panel of services, with their servers and a form that calls a service."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.errors import ZbotError
from zbot.graph.snapshot import full_names
from zbot.names import is_hidden
from zbot.web.command_line import command_line
from zbot.web.form_view import FormView
from zbot.web.list_panel import ListPanel
from zbot.web.message_view import MessageView
from zbot.web.panel import Page, Panel
from zbot.web.service_call import call, run_in_thread, show_error
from zbot.web.table import Cell, Column
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot
    from zbot.web.panel import Section

#: Packages of the services that every node has.
_OF_EVERY_NODE = ("rcl_interfaces/", "type_description_interfaces/")
_COLUMNS = (
    Column("Service", "zb-mono zb-cut"),
    Column("Type", "zb-muted zb-cut zb-spare"),
    Column("Served by", "zb-mono zb-cut"),
)


def _build(page: Page) -> None:
    ListPanel(
        page,
        columns=_COLUMNS,
        rows=_rows,
        details=_ServiceDetails,
        key="service",
        command="zbot service list -t",
        empty="No service yet: start a node, e.g. zbot run add_two_ints_server",
        hidden="Services of every node",
    )


def _rows(graph: Snapshot, hidden: bool) -> dict[str, list[str | Cell]]:
    return {
        name: _row(graph, name, types)
        for name, types in graph.services()
        if hidden or not (is_hidden(name) or types[0].startswith(_OF_EVERY_NODE))
    }


def _row(graph: Snapshot, name: str, types: list[str]) -> list[str | Cell]:
    servers = ", ".join(sorted(set(full_names(graph.on(name, EntityKind.SERVICE)))))
    kind = ", ".join(types)
    return [Cell(name, hint=name), Cell(kind, hint=kind), Cell(servers, hint=servers)]


class _ServiceDetails:
    def __init__(self, section: Section, name: str) -> None:
        self.section, self.name = section, name
        self.type_name = ""
        self.absent = ui.label("No node serves this service.").classes("zb-muted")
        self.place = ui.element("div").classes("zb-col")
        section.page.show_command(command_line("service", "info", name))
        self.end_look = section.live(self.look, 5.0)

    def look(self) -> None:
        """Wait until a node serves the service."""
        types = dict(self.section.system.snapshot().services()).get(self.name)
        if types is None:
            return
        self.end_look()
        self.type_name = types[0]
        self.absent.set_visibility(False)
        with self.place:
            ui.label(self.type_name).classes("zb-muted zb-mono")
            ui.timer(0, self.build, once=True)

    async def build(self) -> None:
        """Show the form when the type is known. Its definition may come from another machine."""
        try:
            service_type = await run_in_thread(self.section.system.interface, self.type_name)
        except ZbotError as error:
            with self.place:
                ui.label(str(error)).classes("zb-bad")
            return
        with self.place:
            self.fill(service_type)

    def fill(self, service_type: Any) -> None:
        """Show the inputs, the button, and the view for the response."""
        ui.label("Request").classes("zb-heading")
        self.form = FormView(service_type.Request, self.changed)
        if self.section.page.read_only:
            ui.label("This page is read-only.").classes("zb-muted")
            return
        self.button = ui.button("Call", on_click=self.call).props("unelevated dense")
        self.button.classes("zb-act")
        self.reply = MessageView(self.section, "Reply")
        self.changed()

    def changed(self) -> None:
        is_right = not self.form.problems
        if self.section.page.read_only:
            return
        self.button.set_enabled(is_right)
        if is_right:
            words = [self.form.yaml()] if self.form.form.members else []
            line = command_line("service", "call", self.name, self.type_name, *words)
            self.section.page.show_command(line)

    async def call(self) -> None:
        """Call the service, and show its response."""
        if self.form.problems:
            return
        self.button.props("loading")
        begun = time.monotonic()
        try:
            request = self.form.message()
            response = await call(self.section.system, self.name, self.type_name, request)
        except ZbotError as error:
            show_error(error)
            self.reply.show_error(error)
        else:
            self.reply.show(response, f"after {1000 * (time.monotonic() - begun):.0f} ms")
        finally:
            self.button.props(remove="loading")


PANEL = Panel("/services", "Services", "handyman", _build)
