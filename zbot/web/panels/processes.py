"""The panel of processes: what runs where, what it costs, and a way to stop it."""

from __future__ import annotations

from datetime import datetime
from typing import TYPE_CHECKING

from nicegui import background_tasks, ui

from zbot.web.call import guarded, in_thread
from zbot.web.command_line import command_line
from zbot.web.list_panel import ListPanel
from zbot.web.panel import Frame, Panel
from zbot.web.process_list import ProcessList, RunningProcess, stop
from zbot.web.system import ReadOnlyError
from zbot.web.table import Cell, Column
from zbot.web.value_text import amount

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot
    from zbot.web.panel import Part

_HZ = 1.0
_COLUMNS = (
    Column("Nodes", "zb-mono zb-cut"),
    Column("Host", "zb-cut", "110px"),
    Column("Process", "zb-number", "76px"),
    Column("CPU", "zb-number", "72px"),
    Column("Memory", "zb-number", "88px"),
    Column("Command", "zb-mono zb-muted zb-cut zb-spare"),
)


class _Processes:
    def __init__(self, frame: Frame) -> None:
        self.frame = frame
        self.list = ProcessList()
        self.found: dict[str, RunningProcess] = {}
        self.number = 0  # of the last look
        self.is_looking = False
        self.revision = -1
        frame.live(self.look, _HZ)
        ListPanel(
            frame,
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
        """Begin to look at the processes; whoever is slow to answer holds nobody up."""
        if not self.is_looking:
            self.is_looking = True
            background_tasks.create(self.look_at_all(), name="zbot processes")

    async def look_at_all(self) -> None:
        """Ask every session and the operating system."""
        try:
            found = await in_thread(self.list.look, self.frame.system)
            self.found = {one.key: one for one in found}
            self.number += 1
        finally:
            self.is_looking = False

    def rows(self, _graph: Snapshot, hidden: bool) -> dict[str, list[str | Cell]]:
        """Return a row for each process."""
        return {
            key: _row(one)
            for key, one in self.found.items()
            if hidden or any("/_" not in node for node in one.nodes)
        }

    def details(self, part: Part, key: str) -> None:
        """Show one process."""
        _Details(part, self, key)


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
    def __init__(self, part: Part, owner: _Processes, key: str) -> None:
        self.part, self.owner, self.key = part, owner, key
        self.one: RunningProcess | None = None
        self.is_asked = False
        self.facts = ui.element("div").classes("zb-facts")
        with ui.element("div").classes("zb-row") as self.buttons:
            self.stop_button = ui.button("Stop", on_click=guarded(self.stop))
            self.stop_button.props("unelevated dense").tooltip("As Ctrl-C in its terminal")
            self.kill_button = ui.button("Kill", on_click=guarded(self.kill), color=None)
            self.kill_button.props("outline dense").classes("zb-danger")
            self.kill_button.tooltip("End it without a goodbye")
        self.note = ui.label().classes("zb-muted")
        self.buttons.set_visibility(False)
        part.live(self.update, 5.0)

    def update(self) -> None:
        """Show what is known now."""
        found = self.owner.found.get(self.key)
        if found is None and self.one is not None:
            self.buttons.set_visibility(False)
            self.note.set_text("It has ended.")
        if found is None or found.nodes == (self.one.nodes if self.one else None):
            return
        self.one = found
        may_stop = found.is_here and not found.is_page and not self.part.frame.read_only
        self.buttons.set_visibility(may_stop)
        if not may_stop:
            self.note.set_text(_why_not(found, read_only=self.part.frame.read_only))
        self.facts.clear()
        with self.facts:
            _show_facts(found)
        self.part.frame.show_command(command_line("node", "info", found.nodes[0]))

    async def stop(self) -> None:
        """Do what Ctrl-C does."""
        self.end(force=False)
        self.note.set_text("It was asked to stop.")

    async def kill(self) -> None:
        """End it at once."""
        self.end(force=True)

    def end(self, *, force: bool) -> None:
        """Stop the process.

        Raises:
            ReadOnlyError: The page may only look.
            StopError: It cannot be stopped from here.
        """
        if self.part.frame.read_only:
            raise ReadOnlyError("stopping processes")
        if self.one is not None:
            words = ["node", "kill", *(["--force"] if force else []), self.one.nodes[0]]
            self.part.frame.show_command(command_line(*words))
            stop(self.one, force=force)


def _why_not(one: RunningProcess, *, read_only: bool) -> str:
    if one.is_page:
        return "This process serves the page that you see."
    if read_only:
        return "This page is read-only."
    return f"It runs on {one.host}: stop it there."


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


def _build(frame: Frame) -> None:
    _Processes(frame)


PANEL = Panel("/processes", "Processes", "memory", _build)
