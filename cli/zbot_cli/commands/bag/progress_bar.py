"""Progress bar of `zbot bag play`, with the text of rosbag2."""

from __future__ import annotations

import contextlib
import sys
from typing import TYPE_CHECKING, TextIO

from zbot.threads.background_thread import background_thread
from zbot.time import S_TO_NS

if TYPE_CHECKING:
    from contextlib import AbstractContextManager
    from threading import Event

    from zbot.bag.player import Player

_CLEAR_LINE = "\x1b[2K"
_EVERY_MESSAGE_HZ = 30  # a terminal shows no more


class ProgressBar:
    """Two lines below the log lines of a player.

    Args:
        player: The player.
        separation_lines: Empty lines between the log lines and the bar.
        stream: The terminal.
    """

    def __init__(self, player: Player, separation_lines: int, stream: TextIO) -> None:
        self._player = player
        self._separation_lines = separation_lines
        self._stream = stream

    def text(self) -> str:
        """Return the second line: `[1570799349.120000000] Duration 1.20/48.47 [R]`."""
        start, end = self._player.bag_start_ns, self._player.bag_end_ns
        now = self._player.position_ns
        seconds, rest = divmod(now, S_TO_NS)
        passed, whole = (now - start) / S_TO_NS, (end - start) / S_TO_NS
        status = self._player.status.value
        return f"[{seconds}.{rest:09}] Duration {passed:.2f}/{whole:.2f} [{status}]"

    def draw(self) -> None:
        """Draw the bar, and move the cursor back to the place of the next log line."""
        down = f"{_CLEAR_LINE}\n" * self._separation_lines + _CLEAR_LINE
        up = f"\x1b[{self._separation_lines + 1}F"
        title = "====== Playback Progress ======\n"
        self._stream.write(f"{down}{title}{_CLEAR_LINE}{self.text()}{up}")
        self._stream.flush()

    def leave(self) -> None:
        """Draw the bar for the last time, and move the cursor below the bar."""
        self.draw()
        self._stream.write("\n" * (self._separation_lines + 2))
        self._stream.flush()


def progress_bar(
    player: Player, rate_hz: float, separation_lines: int
) -> AbstractContextManager[None]:
    """Draw a bar during the `with` block. Draw no bar if the output is not a terminal.

    Args:
        player: The player.
        rate_hz: Updates per second. 0 means no bar. A value below 0 means 30 updates per second.
        separation_lines: Empty lines between the log lines and the bar.
    """
    if not rate_hz or not sys.stdout.isatty():
        return contextlib.nullcontext()
    period_s = 1 / (rate_hz if rate_hz > 0 else _EVERY_MESSAGE_HZ)
    bar = ProgressBar(player, separation_lines, sys.stdout)

    def draw(is_over: Event) -> None:
        with contextlib.suppress(OSError, ValueError):  # the terminal was closed
            while not is_over.wait(period_s):
                bar.draw()
            bar.leave()

    return background_thread("zbot progress bar", draw)
