"""Table row and details of a service or an action that nodes serve."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar

from nicegui import ui

from zbot.errors import ZbotError
from zbot.graph.snapshot import full_names
from zbot.web.page.command_line import command_line
from zbot.web.page.service_call import run_in_thread
from zbot.web.page.table import Cell, Column

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.graph.snapshot import Snapshot
    from zbot.web.page.panel import Section
    from zbot.wire.tokens import EndpointToken


def served_columns(title: str) -> tuple[Column, ...]:
    """Return the columns of a table of services or actions."""
    name, kind = Column(title, "zb-mono zb-cut"), Column("Type", "zb-muted zb-cut zb-spare zb-wide")
    return name, kind, Column("Served by", "zb-mono zb-cut")


def served_row(name: str, types: list[str], servers: Iterable[EndpointToken]) -> list[str | Cell]:
    """Return the row of a service or an action: its name, its types, and the servers' nodes."""
    texts = name, ", ".join(types), ", ".join(sorted(set(full_names(servers))))
    return [Cell(text, hint=text) for text in texts]


class ServedDetails:
    """Details of a service or an action. As soon as a node serves it, `fill` is called.

    Args:
        section: The section that shows the details.
        name: Full name of the service or action.
    """

    noun: ClassVar[str]  #: `service` or `action`

    def __init__(self, section: Section, name: str) -> None:
        self.section, self.name, self.type_name = section, name, ""
        self._absent = ui.label(f"No node serves this {self.noun}.").classes("zb-muted")
        self._place = ui.element("div").classes("zb-col")
        section.page.show_command(command_line(self.noun, "info", name))
        self._end_look = section.live(self._look, 5.0)

    def served(self, graph: Snapshot) -> list[tuple[str, list[str]]]:
        """Return the names and types of all services or actions."""
        raise NotImplementedError

    def fill(self, interface: Any) -> None:
        """Show the form for an interface class.

        If this raises a `ZbotError`, the caller shows the error's text instead.
        """
        raise NotImplementedError

    def _look(self) -> None:
        types = dict(self.served(self.section.system.snapshot())).get(self.name)
        if types is None:
            return
        self._end_look()
        self.type_name = types[0]
        self._absent.set_visibility(False)
        with self._place:
            ui.label(self.type_name).classes("zb-muted zb-mono")
            ui.timer(0, self._build, once=True)

    async def _build(self) -> None:
        # A thread loads the class, because this takes long if another machine sends the definition.
        try:
            interface = await run_in_thread(self.section.system.interface, self.type_name)
            with self._place:
                self.fill(interface)
        except ZbotError as error:
            with self._place:
                ui.label(str(error)).classes("zb-bad")
