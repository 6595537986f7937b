"""Reading of a slow source for a panel, in a thread and again and again."""

from __future__ import annotations

from typing import TYPE_CHECKING, Generic, TypeVar

from nicegui import background_tasks

from zbot.web.page.service_call import READING, run_in_thread

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.web.page.panel import Section

T = TypeVar("T")


class RepeatedReading(Generic[T]):
    """Newest result of a slow function. The function never runs twice at the same time.

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
        section.live(self._start, max_hz)

    def _start(self) -> None:
        if not self._is_reading:
            self._is_reading = True
            background_tasks.create(self._run(), name="zbot reading")

    async def _run(self) -> None:
        try:
            value = await run_in_thread(self._read, threads=READING)
            if value != self.value:
                self.value = value
                self.number += 1
        finally:
            self._is_reading = False
