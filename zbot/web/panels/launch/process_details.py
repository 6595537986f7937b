"""Details of a process of a launch: facts, output, and buttons to restart and stop it."""

from __future__ import annotations

import re
from collections import deque
from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.launch.errors import LaunchControlError
from zbot.web.page.repeated_reading import RepeatedReading
from zbot.web.panels.launch.launch_control import add_buttons, ask_to_confirm, send

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.web.page.panel import Section
    from zbot.web.panels.launch.launch_list import ShownProcess

_HZ = 4.0
_MOST_LINES = 200
#: Codes with which programs colour their output and move the cursor of a terminal.
_CODES = re.compile(r"\x1b(\[[0-9;:?]*[ -/]*[@-~]|[@-Z\\-_])")


def plain(line: str) -> str:
    """Return a line of output without codes for terminals."""
    return "".join(char for char in _CODES.sub("", line) if char.isprintable() or char == "\t")


class _Tail:
    """Last lines of the output of a process. If lines were missed, the oldest are left out."""

    def __init__(self) -> None:
        self._lines: deque[str] = deque(maxlen=_MOST_LINES)
        self._last = 0  # the number of the last line

    def read(self, process: ShownProcess) -> str:
        """Ask for new lines, and return all lines. If the launch has ended, none are new."""
        try:
            answer = process.launch.ask("output", label=process.label, after=self._last)
        except LaunchControlError:
            return "\n".join(self._lines)  # the list says that the launch has ended
        self._last = answer["last"]
        self._lines.extend(plain(str(line)) for line in answer["lines"])
        return "\n".join(self._lines)


class ProcessDetails:
    """Details of a process.

    Args:
        section: The section that shows the details.
        find: Function that returns the process, or None if its launch has ended.
    """

    def __init__(self, section: Section, find: Callable[[], ShownProcess | None]) -> None:
        self._section, self._find = section, find
        self._shown: ShownProcess | None = None
        self._tail = _Tail()
        self._number = 0  # of the output that is shown
        with ui.element("div").classes("zb-facts"):
            self._labels: dict[str, Any] = {}
            for name in ("State", "Process", "Starts", "Command"):
                ui.label(name).classes("zb-muted")
                self._labels[name] = ui.label().classes("zb-mono zb-wrap")
        self._buttons = add_buttons(section, {"Restart": self._restart, "Stop": self._ask_to_stop})
        self._note = ui.label().classes("zb-muted").props("role=status")
        ui.label("Output").classes("zb-heading")
        self._output = ui.element("pre").classes("zb-output")
        self._output.props('tabindex=0 role=log aria-label="Output"')
        self._text: RepeatedReading[str]
        self._text = RepeatedReading(section, self._read_output, "", max_hz=_HZ)
        section.page.show_command("zbot launch")
        section.live(self._update, _HZ)

    def _update(self) -> None:
        found = self._find()
        self._buttons.set_visibility(found is not None)
        if found is None:
            self._note.set_text("The launch has ended." if self._shown else "")
            return
        if found != self._shown:
            self._show(found)
        if self._number != self._text.number:
            self._number = self._text.number
            self._section.page.call("zbot.showOutput", self._output.id, self._text.value)

    def _show(self, found: ShownProcess) -> None:
        if self._shown is not None and self._shown.pid != found.pid:
            self._note.set_text("")
        self._shown = found
        text, classes = found.state
        self._labels["State"].set_text(text)
        self._labels["State"].classes(replace=f"zb-wrap {classes}")
        self._labels["Process"].set_text(str(found.pid))
        self._labels["Starts"].set_text(str(found.runs))
        self._labels["Command"].set_text(found.command)

    def _read_output(self) -> str:
        found = self._shown
        return self._tail.read(found) if found is not None else ""

    async def _restart(self) -> None:
        await self._send("restart", "The process starts again.")

    async def _ask_to_stop(self) -> None:
        if self._shown is not None:
            text = f"{self._shown.label} will end, and is not started again by itself."
            ask_to_confirm("Stop the process?", text, "Stop", self._stop)

    async def _stop(self) -> None:
        await self._send("stop", "The process has been asked to end.")

    async def _send(self, op: str, note: str) -> None:
        found = self._shown
        if found is not None:
            await send(self._section, found.launch, op, label=found.label)
            self._note.set_text(note)
