"""Panel of processes, with nodes, machines, CPU and memory, and buttons to stop processes."""

from __future__ import annotations

from datetime import datetime
from typing import TYPE_CHECKING

from nicegui import background_tasks, ui

from zbot.observer.system import read_only_error
from zbot.observer.value_text import amount
from zbot.web.page.command_line import command_line
from zbot.web.page.list_panel import ListPanel
from zbot.web.page.panel import Page, Panel
from zbot.web.page.service_call import run_in_thread, with_errors_shown
from zbot.web.page.table import Cell, Column
from zbot.web.panels.processes.process_list import ProcessList, RunningProcess, stop

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot
    from zbot.web.page.panel import Section

_HZ = 1.0
_COLUMNS = (
    Column("Nodes", "zb-mono zb-cut"),
    Column("Host", "zb-cut zb-wide", "110px"),
    Column("Process", "zb-number zb-wide", "76px"),
    Column("CPU", "zb-number", "72px"),
    Column("Memory", "zb-number", "88px"),
    Column("Command", "zb-mono zb-muted zb-cut zb-long zb-spare zb-wide"),
)


class _Processes:
    def __init__(self, page: Page) -> None:
        self.page = page
        self.list = ProcessList()
        self.found: dict[str, RunningProcess] = {}
        self.number = 0  # how many times the processes were listed
        self.is_looking = False
        self.revision = -1
        page.live(self.look, _HZ)
        ListPanel(
            page,
            columns=_COLUMNS,
            rows=self.rows,
            details=self.details,
            key="process",
            command="zbot node list",
            empty="No node is running: start one, e.g. zbot run talker",
            hidden="Hidden nodes",
            version=lambda: self.number,
        )

    def look(self) -> None:
        """Start to list the processes in the background, because sessions may answer slowly."""
        if not self.is_looking:
            self.is_looking = True
            background_tasks.create(self.look_at_all(), name="zbot processes")

    async def look_at_all(self) -> None:
        """List the processes. The data comes from all sessions and the operating system."""
        try:
            found = await run_in_thread(self.list.look, self.page.system)
            self.found = {one.key: one for one in found}
            self.number += 1
        finally:
            self.is_looking = False

    def rows(self, _graph: Snapshot, hidden: bool) -> dict[str, list[str | Cell]]:
        return {
            key: _row(one)
            for key, one in self.found.items()
            if hidden or any("/_" not in node for node in one.nodes)
        }

    def details(self, section: Section, key: str) -> None:
        _Details(section, self, key)


def _row(one: RunningProcess) -> list[str | Cell]:
    nodes = ", ".join(one.nodes)
    return [
        Cell(nodes, hint=nodes),
        Cell(one.host, hint=one.host),
        str(one.pid),
        "" if one.cpu_percent is None else f"{one.cpu_percent:.0f} %",
        "" if one.memory_bytes is None else amount(one.memory_bytes, "B"),
        Cell(one.command, hint=one.command),
    ]


class _Details:
    def __init__(self, section: Section, owner: _Processes, key: str) -> None:
        self.section, self.owner, self.key = section, owner, key
        self.one: RunningProcess | None = None
        self.is_asked = False
        self.facts = ui.element("div").classes("zb-facts")
        with ui.element("div").classes("zb-row") as self.buttons:
            self.stop_button = ui.button("Stop", on_click=with_errors_shown(self.stop))
            self.stop_button.props("unelevated dense").tooltip("Same as Ctrl-C in the terminal")
            self.kill_button = ui.button("Kill", on_click=with_errors_shown(self.kill), color=None)
            self.kill_button.props("outline dense").classes("zb-danger")
            self.kill_button.tooltip("Ends the process immediately")
        self.note = ui.label().classes("zb-muted")
        self.buttons.set_visibility(False)
        section.live(self.update, 5.0)

    def update(self) -> None:
        found = self.owner.found.get(self.key)
        if found is None and self.one is not None:
            self.buttons.set_visibility(False)
            self.note.set_text("The process has ended.")
        if found is None or found.nodes == (self.one.nodes if self.one else None):
            return
        self.one = found
        may_stop = found.is_here and not found.is_page and not self.section.page.read_only
        self.buttons.set_visibility(may_stop)
        if not may_stop:
            self.note.set_text(_why_not(found, read_only=self.section.page.read_only))
        self.facts.clear()
        with self.facts:
            _show_facts(found)
        self.section.page.show_command(command_line("node", "info", found.nodes[0]))

    async def stop(self) -> None:
        """Stop the process, as Ctrl-C does."""
        self.end(force=False)
        self.note.set_text("The process has been asked to stop.")

    async def kill(self) -> None:
        self.end(force=True)

    def end(self, *, force: bool) -> None:
        """Stop the process.

        Raises:
            ViewerError: The page is read-only, or the process cannot be stopped from this machine.
        """
        if self.section.page.read_only:
            raise read_only_error("stopping processes")
        if self.one is not None:
            words = ["node", "kill", *(["--force"] if force else []), self.one.nodes[0]]
            self.section.page.show_command(command_line(*words))
            stop(self.one, force=force)


def _why_not(one: RunningProcess, *, read_only: bool) -> str:
    if one.is_page:
        return "This process serves this page."
    if read_only:
        return "This page is read-only."
    return f"This process runs on {one.host}: stop it there."


def _show_facts(one: RunningProcess) -> None:
    started = datetime.fromtimestamp(one.started_ns / 1e9).astimezone()
    facts = {
        "Nodes": "\n".join(one.nodes),
        "Host": one.host,
        "Process": str(one.pid),
        "Command": one.command,
        "Started": f"{started:%Y-%m-%d %H:%M:%S}",
        "zbot": one.version,
    }
    for name, text in facts.items():
        ui.label(name).classes("zb-muted")
        ui.label(text).classes("zb-mono zb-wrap")


def _build(page: Page) -> None:
    _Processes(page)


PANEL = Panel("/processes", "Processes", "memory", _build)
