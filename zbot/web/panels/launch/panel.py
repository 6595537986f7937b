"""Panel of what `zbot launch` has started on this machine: processes, output, restart and stop."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from zbot.web.page.list_panel import ListPanel
from zbot.web.page.panel import Page, Panel
from zbot.web.page.repeated_reading import RepeatedReading
from zbot.web.page.table import Cell, Column
from zbot.web.panels.launch.launch_details import LaunchDetails
from zbot.web.panels.launch.launch_list import is_process, look, rows
from zbot.web.panels.launch.process_details import ProcessDetails

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from zbot.graph.snapshot import Snapshot
    from zbot.web.page.panel import Section
    from zbot.web.panels.launch.launch_list import ShownLaunch, ShownProcess

_HZ = 2.0
_COLUMNS = (
    Column("Launch", "zb-cut"),
    Column("State", "zb-cut", "120px"),
    Column("Since", "zb-number zb-wide", "76px"),
    Column("Process", "zb-number zb-wide", "76px"),
    Column("Command", "zb-mono zb-muted zb-cut zb-long zb-spare zb-wide"),
)


class LaunchPanel:
    """The list of launches, and the details of a launch or a process."""

    def __init__(self, page: Page) -> None:
        domain = page.system.domain_id
        self._launches: RepeatedReading[list[ShownLaunch]]
        self._launches = RepeatedReading(page, lambda: look(domain), [], max_hz=_HZ)
        ListPanel(
            page,
            columns=_COLUMNS,
            rows=self._rows,
            details=self._details,
            key="process",
            command="zbot launch",
            empty="No launch runs here: start one, e.g. zbot launch robot",
            hidden="Only running",
            version=lambda: (self._launches.number, int(time.monotonic())),  # ages grow
        )

    def launch(self, key: str) -> ShownLaunch | None:
        """Return the launch of a row, or None if it has ended."""
        return next((launch for launch in self._launches.value if launch.key == key), None)

    def process(self, key: str) -> ShownProcess | None:
        """Return the process of a row, or None if its launch has ended."""
        processes = (process for launch in self._launches.value for process in launch.processes)
        return next((process for process in processes if process.key == key), None)

    def _rows(self, _: Snapshot, only_running: bool) -> Mapping[str, Sequence[str | Cell]]:
        return rows(self._launches.value, only_running=only_running)

    def _details(self, section: Section, key: str) -> None:
        if is_process(key):
            ProcessDetails(section, lambda: self.process(key))
        else:
            LaunchDetails(section, lambda: self.launch(key))


def _build(page: Page) -> None:
    LaunchPanel(page)


PANEL = Panel("/launch", "Launch", "rocket_launch", _build)
