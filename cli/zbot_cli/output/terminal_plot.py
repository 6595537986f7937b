"""Plot of `zbot plot --terminal`, drawn in the terminal."""

from __future__ import annotations

import os
import shutil
import sys
import threading
import time
from collections import deque
from typing import TYPE_CHECKING

from zbot.text.terminal import escape_control_characters, write_styled
from zbot_cli.output.braille import Curve, draw

if TYPE_CHECKING:
    from zbot.observer.curve import Curves
    from zbot.observer.system import System
    from zbot.observer.watch import Watch

_FRAME_S = 0.1
#: Seconds between two pictures if the output is a file or a pipe, which keeps all pictures.
_PIPED_FRAME_S = 1.0
_MOST_POINTS = 20_000
_HOME, _CLEAR_LINE, _CLEAR_BELOW = "\033[H", "\033[K", "\033[J"
_ENTER, _LEAVE = "\033[?1049h\033[?25l", "\033[?25h\033[?1049l"


class _Watcher:
    def __init__(self, system: System) -> None:
        self._system = system

    def watch(self, topic: str, *, keep: int) -> Watch:
        return self._system.watch(topic, keep=keep)


class TerminalPlot:
    """Plot that is drawn until Ctrl-C, or for a time.

    Args:
        system: The running system.
        names: Pairs of a topic and a field. A topic with an empty field means all its numeric
            fields.
        window_s: Seconds that the plot shows.
        duration_s: Seconds until the end, or `None` for no end.
    """

    def __init__(
        self,
        system: System,
        names: list[tuple[str, str]],
        *,
        window_s: float,
        duration_s: float | None,
    ) -> None:
        from zbot.observer.curve import Curves  # noqa: PLC0415 - not needed by `zbot plot --help`

        self._curves: Curves = Curves(_Watcher(system))
        for topic, field in names:
            self._curves.add(topic, field)
        self._points: dict[str, deque[tuple[float, float]]] = {}
        self._window_s = window_s
        self._duration_s = duration_s
        self._began_s = time.time()
        self._is_terminal = sys.stdout.isatty()

    def run(self) -> None:
        """Draw until Ctrl-C or the end of the duration."""
        if not self._is_terminal:
            self._loop(_PIPED_FRAME_S)
            return
        write_styled(sys.stdout, _ENTER)
        try:
            self._loop(_FRAME_S)
        finally:
            # _LEAVE removes the plot, so the last picture is printed again above the prompt.
            write_styled(sys.stdout, _LEAVE + "\n".join(self._lines()) + "\n")

    def _loop(self, frame_s: float) -> None:
        pause = threading.Event()
        while self._duration_s is None or time.time() - self._began_s < self._duration_s:
            pause.wait(frame_s)
            self._read_new_points()
            self._show()

    def _read_new_points(self) -> None:
        for name, flat in self._curves.take().items():
            points = self._points.setdefault(name, deque(maxlen=_MOST_POINTS))
            points.extend(zip(flat[::2], flat[1::2], strict=True))

    def _show(self) -> None:
        lines = self._lines()
        if self._is_terminal:
            text = "".join(f"{line}{_CLEAR_LINE}\n" for line in lines[:-1]) + lines[-1]
            write_styled(sys.stdout, f"{_HOME}{text}{_CLEAR_LINE}{_CLEAR_BELOW}")
        else:
            sys.stdout.write("\n".join(lines) + "\n\n")
        sys.stdout.flush()

    def _lines(self) -> list[str]:
        size = shutil.get_terminal_size()
        now_s = time.time() - self._began_s
        to_s = max(now_s, self._window_s)
        curves = [
            Curve(curve.name, [(time_s - self._began_s, value) for time_s, value in points])
            for curve in self._curves.curves
            for points in (self._points.get(curve.name, ()),)
        ]
        curves += [Curve(topic, ()) for topic in self._curves.waiting]
        lines = draw(
            curves,
            width=size.columns,
            height=size.lines,
            from_s=to_s - self._window_s,
            to_s=to_s,
            coloured=self._is_terminal and not os.environ.get("NO_COLOR"),
        )
        if not self._is_terminal:
            return lines
        return [escape_control_characters(line, keep_colours=True) for line in lines]
