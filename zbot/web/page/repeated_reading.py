"""Reading of a slow source for a panel, in a thread and again and again."""

from __future__ import annotations

import traceback
from typing import TYPE_CHECKING, Generic, TypeVar

from nicegui import background_tasks, ui

from zbot.errors import ZbotError
from zbot.log import get_logger
from zbot.web.page.service_call import READING, run_in_thread

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.web.page.panel import Section

T = TypeVar("T")


class RepeatedReading(Generic[T]):
    """Newest result of a slow function. The function never runs twice at the same time.

    If the function raises an error, the page shows it in the current element. The function runs
    again, and the last result stays until then.

    Args:
        section: The section that needs the result. After its end, the function runs no more.
        read: The function. It runs in a thread while the page is visible.
        value: The value until the first result.
        max_hz: How often the function runs at most, in a second.

    Attributes:
        value: The newest result.
        number: How many times the result has changed.
    """

    def __init__(self, section: Section, read: Callable[[], T], value: T, *, max_hz: float) -> None:
        self.value = value
        self.number = 0
        self._read = read
        self._is_reading = False
        self._problem = ""
        self._said = ui.label().classes("zb-bad")
        self._said.set_visibility(False)
        section.live(self._start, max_hz)

    def _start(self) -> None:
        if not self._is_reading:
            self._is_reading = True
            background_tasks.create(self._run(), name="zbot reading")

    async def _run(self) -> None:
        try:
            value = await run_in_thread(self._read, threads=READING)
        except Exception as error:  # noqa: BLE001 - the page shows it
            self._say(error)
        else:
            self._say(None)
            if value != self.value:
                self.value = value
                self.number += 1
        finally:
            self._is_reading = False

    def _say(self, error: Exception | None) -> None:
        problem = "" if error is None else str(error) or repr(error)
        if problem == self._problem:
            return  # the log has it already
        self._problem = problem
        self._said.set_text(problem)
        self._said.set_visibility(bool(problem))
        if error is not None and not isinstance(error, ZbotError):
            get_logger("zbot.web").error("".join(traceback.format_exception(error)))
