"""Count of what a device has sent and of what was lost, with one log line for each reason."""

from __future__ import annotations

import threading
from collections import Counter
from typing import TYPE_CHECKING

from zbot.errors import counted
from zbot.text.terminal import single_line

if TYPE_CHECKING:
    from zbot.log import Logger

_SHOWN_CHARACTERS = 80
_MOST_REASONS = 200


class Tally:
    """Counter of lines or messages. Any thread may call the methods.

    The first loss of each reason is logged immediately, and later ones in `report`.

    Args:
        log: The logger of the device's node.
        noun: What is counted, e.g. `line`.
    """

    def __init__(self, log: Logger, noun: str) -> None:
        self._log, self._noun = log, noun
        self._lock = threading.Lock()
        self.received = 0  #: from the device
        self.published = 0  #: messages on topics
        self.sent = 0  #: to the device
        self.shown = 0  #: as log lines
        self._lost: Counter[str] = Counter()
        self._unreported: dict[str, tuple[int, str]] = {}

    @property
    def lost(self) -> int:
        """Number of all that was lost."""
        with self._lock:
            return self._lost.total()

    def lose(
        self,
        reason: str,
        example: str = "",
        advice: str = "",
        count: int = 1,
        *,
        is_usual: bool = False,
    ) -> None:
        """Note that something was lost.

        Args:
            reason: Why. It is a part of a sentence: `no topic and no value`.
            example: What was lost.
            advice: What the user can do. It is logged once for each reason.
            count: How many were lost.
            is_usual: Whether this also happens if all is well. It is then no warning.
        """
        with self._lock:
            if len(self._lost) >= _MOST_REASONS and reason not in self._lost:
                reason = "another reason"
            is_first = reason not in self._lost
            self._lost[reason] += count
            if not is_first:
                before, _ = self._unreported.get(reason, (0, ""))
                self._unreported[reason] = (before + count, example)
        if is_first:
            text = f"{counted(count, self._noun)} lost: {reason}{_shown(example)}"
            text = f"{text}; {advice}" if advice else text
            if is_usual:
                self._log.info(text)
            else:
                self._log.warning(text)

    def report(self) -> None:
        """Log the losses since the last report."""
        with self._lock:
            unreported, self._unreported = self._unreported, {}
        for reason, (count, example) in unreported.items():
            self._log.warning(
                f"{counted(count, f'more {self._noun}')} lost: {reason}{_shown(example)}"
            )

    def summary(self) -> str:
        """Return one line with all counts."""
        with self._lock:
            lost = ", ".join(f"{count} lost ({reason})" for reason, count in self._lost.items())
        text = f"{counted(self.received, self._noun)} received, {self.published} published"
        shown = f", {self.shown} shown as text" if self.shown else ""
        sent = f", {self.sent} sent" if self.sent else ""
        return f"{text}{shown}{sent}, {lost or '0 lost'}"


def _shown(example: str) -> str:
    text = single_line(example, _SHOWN_CHARACTERS)
    return f" ({text})" if text else ""
