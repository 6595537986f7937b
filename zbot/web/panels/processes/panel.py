"""Panel of processes, with nodes, machines, CPU and memory, and buttons to stop processes."""

from __future__ import annotations

from datetime import datetime
from typing import TYPE_CHECKING

from nicegui import ui

from zbot.observer.system import read_only_error
from zbot.observer.value_text import amount
from zbot.web.page.command_line import command_line
from zbot.web.page.list_panel import ListPanel
from zbot.web.page.panel import Page, Panel
from zbot.web.page.repeated_reading import RepeatedReading
from zbot.web.page.service_call import with_errors_shown
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
        processes = ProcessList()
        self.reading: RepeatedReading[list[RunningProcess]]
        self.reading = RepeatedReading(page, lambda: processes.look(page.system), [], max_hz=_HZ)
        ListPanel(
            page,
            columns=_COLUMNS,
            rows=self.rows,
            details=self.details,
            key="process",
            command="zbot node list",
            empty="No node is running: start one, e.g. zbot run talker",
            hidden="Hidden nodes",
            version=lambda: self.reading.number,
        )

    @property
    def found(self) -> dict[str, RunningProcess]:
        """The processes by key. The data comes from all sessions and the operating system."""
        return {process.key: process for process in self.reading.value}

    def rows(self, _graph: Snapshot, hidden: bool) -> dict[str, list[str | Cell]]:
        return {
            key: _row(process)
            for key, process in self.found.items()
            if hidden or any("/_" not in node for node in process.nodes)
        }

    def details(self, section: Section, key: str) -> None:
        _Details(section, self, key)


def _row(process: RunningProcess) -> list[str | Cell]:
    nodes = ", ".join(process.nodes)
    return [
        Cell(nodes, hint=nodes),
        Cell(process.host, hint=process.host),
        str(process.pid),
        "" if process.cpu_percent is None else f"{process.cpu_percent:.0f} %",
        "" if process.memory_bytes is None else amount(process.memory_bytes, "B"),
        Cell(process.command, hint=process.command),
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


def _why_not(process: RunningProcess, *, read_only: bool) -> str:
    if process.is_page:
        return "This process serves this page."
    if read_only:
        return "This page is read-only."
    return f"This process runs on {process.host}: stop it there."


def _show_facts(process: RunningProcess) -> None:
    started = datetime.fromtimestamp(process.started_ns / 1e9).astimezone()
    facts = {
        "Nodes": "\n".join(process.nodes),
        "Host": process.host,
        "Process": str(process.pid),
        "Command": process.command,
        "Started": f"{started:%Y-%m-%d %H:%M:%S}",
        "zbot": process.version,
    }
    for name, text in facts.items():
        ui.label(name).classes("zb-muted")
        ui.label(text).classes("zb-mono zb-wrap")


def _build(page: Page) -> None:
    _Processes(page)


PANEL = Panel("/processes", "Processes", "memory", _build)
