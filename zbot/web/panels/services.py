"""Panel of services, with their servers and a form that calls a service."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.errors import ZbotError
from zbot.names import is_hidden
from zbot.web.forms.form_view import FormView
from zbot.web.page.command_line import command_line
from zbot.web.page.list_panel import ListPanel
from zbot.web.page.message_view import MessageView
from zbot.web.page.panel import Page, Panel
from zbot.web.page.served_details import ServedDetails, served_columns, served_row
from zbot.web.page.service_call import call, show_error
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot
    from zbot.web.page.table import Cell

#: Packages of the services that every node has.
_OF_EVERY_NODE = ("rcl_interfaces/", "type_description_interfaces/")


def _build(page: Page) -> None:
    ListPanel(
        page,
        columns=served_columns("Service"),
        rows=_rows,
        details=_ServiceDetails,
        key="service",
        command="zbot service list -t",
        empty="No service yet: start a node, e.g. zbot run add_two_ints_server",
        hidden="Services of every node",
    )


def _rows(graph: Snapshot, hidden: bool) -> dict[str, list[str | Cell]]:
    return {
        name: served_row(name, types, graph.on(name, EntityKind.SERVICE))
        for name, types in graph.services()
        if hidden or not (is_hidden(name) or types[0].startswith(_OF_EVERY_NODE))
    }


class _ServiceDetails(ServedDetails):
    noun = "service"

    def served(self, graph: Snapshot) -> list[tuple[str, list[str]]]:
        return graph.services()

    def fill(self, interface: Any) -> None:
        """Show the inputs, the button, and the view for the response."""
        ui.label("Request").classes("zb-heading")
        self.form = FormView(interface.Request, self.changed)
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
