"""List of the running launches of this user, with their processes, as the page shows them."""

from __future__ import annotations

import time
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from zbot.launch.control.running_launch import running_launches
from zbot.launch.errors import LaunchControlError
from zbot.observer.value_text import duration
from zbot.web.page.table import Cell

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from zbot.launch.control.running_launch import RunningLaunch

_OF = " of "  # between the label of a process and the key of its launch


@dataclass(frozen=True, slots=True)
class ShownProcess:
    """Process of a launch."""

    key: str  #: of the row. It stays the same when the process is started again
    launch: RunningLaunch
    label: str
    command: str
    pid: int
    runs: int
    since_s: float  #: begin of the state, in seconds since the epoch
    is_running: bool
    exit_code: int | None

    @property
    def state(self) -> tuple[str, str]:
        """The state as text, and its class of CSS."""
        if self.is_running:
            return "running", "zb-good"
        if self.exit_code == 0:
            return "finished", "zb-muted"
        if self.exit_code is not None and self.exit_code < 0:
            return f"ended by signal {-self.exit_code}", "zb-muted"
        return f"failed, exit code {self.exit_code}", "zb-bad"


@dataclass(frozen=True, slots=True)
class ShownLaunch:
    """Running launch, with the facts that it gave last."""

    key: str  #: of the row
    launch: RunningLaunch
    file: str
    arguments: tuple[str, ...]
    started_s: float
    is_ending: bool
    processes: tuple[ShownProcess, ...]

    @property
    def name(self) -> str:
        """The name of the launch file."""
        return Path(self.file).name

    @property
    def state(self) -> str:
        """The state as text."""
        running = sum(process.is_running for process in self.processes)
        return "ending" if self.is_ending else f"{running} running"


def look(domain: int) -> list[ShownLaunch]:
    """Ask the running launches of a domain. This may take seconds, so call it in a thread."""
    found = []
    for launch in running_launches(domain):
        try:
            found.append(_shown(launch, launch.ask("look")))
        except (LaunchControlError, KeyError, TypeError, ValueError):
            continue  # it has ended, or belongs to another version of zbot
    return found


def is_process(key: str) -> bool:
    """Return whether a key is that of a process, not that of a launch."""
    return _OF in key


def _shown(launch: RunningLaunch, facts: dict[str, Any]) -> ShownLaunch:
    key = f"{Path(facts['file']).name} {launch.pid}".replace(_OF, "_of_")
    return ShownLaunch(
        key,
        launch,
        str(facts["file"]),
        tuple(map(str, facts["arguments"])),
        float(facts["started"]),
        bool(facts["ending"]),
        tuple(_process(key, launch, one) for one in facts["processes"]),
    )


def _process(key: str, launch: RunningLaunch, facts: dict[str, Any]) -> ShownProcess:
    code = facts["exit_code"]
    return ShownProcess(
        f"{facts['label']}{_OF}{key}",
        launch,
        str(facts["label"]),
        str(facts["command"]),
        int(facts["pid"]),
        int(facts["runs"]),
        float(facts["since"]),
        bool(facts["running"]),
        None if code is None else int(code),
    )


def rows(
    launches: Iterable[ShownLaunch], *, only_running: bool, now_s: float | None = None
) -> dict[str, Sequence[str | Cell]]:
    """Return the rows of launches and their processes, by key."""
    now = time.time() if now_s is None else now_s
    found: dict[str, Sequence[str | Cell]] = {}
    for launch in launches:
        name = Cell(launch.name, hint=launch.file)
        found[launch.key] = [name, launch.state, duration(now - launch.started_s), "", ""]
        for process in launch.processes:
            if process.is_running or not only_running:
                found[process.key] = _row(process, now)
    return found


def _row(process: ShownProcess, now_s: float) -> list[str | Cell]:
    text, classes = process.state
    return [
        Cell(process.label, "zb-mono", indent=1),
        Cell(text, classes),
        duration(now_s - process.since_s),
        str(process.pid) if process.is_running else "",
        Cell(process.command, hint=process.command),
    ]
