"""Errors that stop launch tests. A failed assertion is not such an error."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.errors import ZbotError

if TYPE_CHECKING:
    from collections.abc import Iterable


class NoMatchingProcessError(ZbotError, LookupError):
    """A test refers to an unknown process."""

    def __init__(self, process: str, known: Iterable[str]) -> None:
        self.process, self.known = process, sorted(known)
        what = f"Did not find any process matching {process}" if process else "No process started"
        super().__init__(f"{what}. Known are: {', '.join(self.known) or 'none'}")


class SeveralProcessesError(ZbotError, LookupError):
    """A test refers to one process, but several processes match."""

    def __init__(self, process: str, found: Iterable[str]) -> None:
        self.process, self.found = process, sorted(found)
        super().__init__(f"Found multiple processes matching {process}: {', '.join(self.found)}")


class LaunchTestError(ZbotError):
    """A test of a launch cannot be run."""

    def __init__(self, reason: str, hint: str = "") -> None:
        self.reason, self.hint = reason, hint
        super().__init__(f"{reason}: {hint}" if hint else reason)
