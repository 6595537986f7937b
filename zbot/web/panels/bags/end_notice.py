"""Notice of the early end of a recording or a playback."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path


class Work(Protocol):
    """Recording or playback in the background."""

    path: Path
    error: str

    @property
    def is_running(self) -> bool:
        """Whether the work has not ended."""
        ...


class EndNotice:
    """Tells a page once that a recording or a playback has ended early.

    Args:
        noun: `recording` or `playback`.
        work: Returns the present recording or playback, or None.
    """

    def __init__(self, noun: str, work: Callable[[], Work | None]) -> None:
        self._noun, self._work = noun, work
        self._told = self._failed()

    def _failed(self) -> Work | None:
        work = self._work()
        return work if work is not None and not work.is_running and work.error else None

    def skip(self) -> None:
        """Do not tell what has failed until now, because the page has shown its error."""
        self._told = self._failed()

    def news(self) -> str:
        """Return the sentence. It is empty if nothing has failed, or if the page knows it."""
        failed = self._failed()
        if failed is None or failed is self._told:
            return ""
        self._told = failed
        return f"The {self._noun} of {failed.path.name} has ended: {failed.error}"
