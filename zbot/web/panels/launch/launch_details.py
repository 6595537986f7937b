"""Details of a running launch, with a button that stops it."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from nicegui import ui

from zbot.observer.value_text import duration
from zbot.web.page.command_line import command_line
from zbot.web.panels.launch.launch_control import add_buttons, ask_to_confirm, send

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.web.page.panel import Section
    from zbot.web.panels.launch.launch_list import ShownLaunch

_HZ = 2.0


class LaunchDetails:
    """Details of a launch.

    Args:
        section: The section that shows the details.
        find: Function that returns the launch, or None if it has ended.
    """

    def __init__(self, section: Section, find: Callable[[], ShownLaunch | None]) -> None:
        self._section, self._find = section, find
        self._shown: ShownLaunch | None = None
        with ui.element("div").classes("zb-facts"):
            self._labels = {}
            for name in ("File", "Arguments", "Process", "Since"):
                ui.label(name).classes("zb-muted")
                self._labels[name] = ui.label().classes("zb-mono zb-wrap")
        self._buttons = add_buttons(section, {"Stop the launch": self._ask})
        self._note = ui.label().classes("zb-muted").props("role=status")
        section.live(self._update, _HZ)

    def _update(self) -> None:
        found = self._find()
        self._buttons.set_visibility(found is not None and not found.is_ending)
        if found is None:
            self._note.set_text("The launch has ended." if self._shown else "")
            return
        if self._shown is None:
            words = command_line("launch", found.file, *found.arguments)
            self._section.page.show_command(words)
        self._shown = found
        self._labels["File"].set_text(found.file)
        self._labels["Arguments"].set_text(" ".join(found.arguments) or "none")
        self._labels["Process"].set_text(str(found.launch.pid))
        self._labels["Since"].set_text(duration(time.time() - found.started_s))

    async def _ask(self) -> None:
        found = self._shown
        if found is not None:
            text = f"{found.name} and all its processes will end."
            ask_to_confirm("Stop the launch?", text, "Stop", self._stop)

    async def _stop(self) -> None:
        if self._shown is not None:
            await send(self._section, self._shown.launch, "end")
            self._note.set_text("The launch has been asked to end.")
