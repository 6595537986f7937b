"""Dead man's switch: commands of a browser, with a zero when the browser says nothing more."""

from __future__ import annotations

import threading
import time
from typing import TYPE_CHECKING

from zbot.threads.on_demand_thread import OnDemandThread

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

#: A browser repeats its values 20 times a second. After this silence the switch sends a zero.
SILENCE_S = 0.2


def _start_thread(run: Callable[[], None]) -> None:
    threading.Thread(target=run, name="zbot drive", daemon=True).start()


class DeadManSwitch:
    """Sender of the values that a browser repeats while its user holds a control.

    A *press* lasts from the moment when the user takes a control until the user has released all
    controls. Each press has a number, and a later press has a higher number. When a press ends, the
    switch sends one zero for each value, and then nothing. A press ends if all values are zero, if
    the browser is silent for `SILENCE_S`, and with `stop`. Values of an ended press that arrive
    late do not move the robot again.

    The silence begins when the browser said its last word, and not when the word arrived: a busy
    network or web server does not make it longer. A thread of its own measures it while there is a
    press, because the other threads may be busy.

    Any thread may call any method.

    Args:
        send: Function that publishes values.
        clock: Function that returns seconds.
        start: Function that runs a function in a thread.
    """

    def __init__(
        self,
        send: Callable[[Sequence[float]], None],
        clock: Callable[[], float] = time.monotonic,
        start: Callable[[Callable[[], None]], object] = _start_thread,
    ) -> None:
        self._send, self._clock = send, clock
        self._lock = threading.RLock()
        self._watchdog = OnDemandThread(start, self.check)
        self._press = 0  # the press that drives now, or 0
        self._ended = 0  # the newest press that has ended
        self._said_s = 0.0  # when the last word was said
        self._offset_s = 0.0  # of this clock from the browser's, with the least delay of a word
        self.values: list[float] = []  #: the values that were sent last

    def hear(self, press: int, values: Sequence[float], said_s: float) -> bool:
        """Send the values of a press.

        Args:
            press: The number of the press.
            values: The values.
            said_s: When the browser said it, in seconds of the browser's clock.

        Returns:
            False if this press has ended. The user must release the control and take it again.
        """
        with self._lock:
            if press <= self._ended:
                return False
            self._note_time(press, said_s)
            is_new = press != self._press
            self._press, self.values = press, list(values)
            if not any(values):
                self.stop()
            elif self.check() is None:
                return False  # the word was under way for too long
            else:
                self._send(self.values)
                if is_new:
                    self._watchdog.wake()
            return True

    def _note_time(self, press: int, said_s: float) -> None:
        offset_s = self._clock() - said_s
        self._offset_s = offset_s if press != self._press else min(offset_s, self._offset_s)
        self._said_s = said_s + self._offset_s

    def check(self) -> float | None:
        """End the press if the browser is silent.

        Returns:
            The seconds until the next check, or None if there is no press.
        """
        with self._lock:
            if not self._press:
                return None
            left_s = self._said_s + SILENCE_S - self._clock()
            if left_s <= 0:
                self.stop()
                return None
            return left_s

    def stop(self) -> None:
        """End the press now. Without a press, do nothing."""
        with self._lock:
            if not self._press:
                return
            self._ended, self._press = self._press, 0
            self.values = [0.0] * len(self.values)
            self._send(self.values)
