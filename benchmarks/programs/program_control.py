"""Control of a measured program by lines of JSON: each line gets one line as answer.

Programs import only this module, `sample_messages` and their library. So the library may come from
another checkout.
"""

from __future__ import annotations

import json
import sys
import threading
import time
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

_NO_PROGRESS_S = 3.0  # the time without a message after which the missing messages are lost
_PAUSE_S = 0.005


def arguments() -> tuple[str, dict[str, Any]]:
    """Return the role and the options, which are the two words of the command line."""
    return sys.argv[1], json.loads(sys.argv[2])


def say(**facts: Any) -> None:
    print(json.dumps(facts), flush=True)


def await_word() -> None:
    if not sys.stdin.readline():
        sys.exit()  # the benchmark has ended


def serve(answer: Callable[..., dict[str, Any]]) -> None:
    """Answer each line in a thread, which sleeps until a line comes."""

    def run() -> None:
        for line in sys.stdin:
            say(**answer(**json.loads(line)))

    threading.Thread(target=run, daemon=True).start()


def cpu() -> dict[str, Any]:
    """Return the CPU seconds of this process in all its threads."""
    return {"cpu": time.process_time()}


class Tally:
    """Counts messages. An answer has the rate since the last answer."""

    __slots__ = ("_clock", "first", "got", "last")

    def __init__(self) -> None:
        self._clock = time.perf_counter
        self._reset()

    def _reset(self) -> None:
        self.got, self.first, self.last = 0, 0.0, 0.0

    def count(self, _: object) -> None:
        self.last = self._clock()
        if not self.got:
            self.first = self.last
        self.got += 1

    def result(self, until: int) -> dict[str, Any]:
        """Wait for `until` messages. Return their rate, how many did not come, and the CPU time."""
        seen, progress = -1, time.monotonic()
        while self.got < until and time.monotonic() - progress < _NO_PROGRESS_S:
            if self.got != seen:
                seen, progress = self.got, time.monotonic()
            time.sleep(_PAUSE_S)
        # Messages are on the way for less than a millisecond when few are sent.
        seconds = self.last - self.first
        found = {"rate": (self.got - 1) / seconds if seconds else 0.0, "lost": until - self.got}
        arrival = time.time() - (self._clock() - self.last)
        self._reset()
        return {**found, "arrival": arrival, **cpu()}


class Delays:
    """Times from a message's publish() to the subscriber's callback, in another process.

    All processes of a machine have the same monotonic clock.
    """

    def __init__(self) -> None:
        self._delays: list[int] = []

    def note(self, sent_ns: int) -> None:
        self._delays.append(time.monotonic_ns() - sent_ns)

    def result(self, until: int) -> dict[str, Any]:
        """Wait for `until` messages. Return their delays in nanoseconds, and the CPU time."""
        end = time.monotonic() + _NO_PROGRESS_S
        while len(self._delays) < until and time.monotonic() < end:
            time.sleep(_PAUSE_S)
        delays, self._delays = self._delays, []
        return {"delays": delays, **cpu()}


class Trips:
    """Times round trips. Each trip begins when the trip before it has ended.

    Args:
        publish: Sends a message, which comes back.
        wanted: How many trips are timed after a tenth as many trips that only warm up.
        finish: Called after the last trip.
    """

    def __init__(
        self, publish: Callable[[], object], wanted: int, finish: Callable[[], object]
    ) -> None:
        self._publish = publish
        self._wanted = wanted
        self._warming = wanted // 10
        self._times: list[int] = []
        self._cpu = 0.0
        self._begun = 0
        self._finish = finish

    @property
    def count(self) -> int:
        return len(self._times)

    def begin(self) -> None:
        self._begun = time.perf_counter_ns()
        self._publish()

    def end(self, _: object) -> None:
        self._times.append(time.perf_counter_ns() - self._begun)
        if self._warming and len(self._times) == self._warming:
            self._warming = 0
            self._times.clear()
            say(ready=True)
            await_word()
            self._cpu = time.process_time()
        if len(self._times) < self._wanted:
            self.begin()
        else:
            say(trips=self._times, cpu=time.process_time() - self._cpu)
            self._finish()


def publish_for(publish: Callable[[], object], seconds: float, rate: float = 0.0) -> None:
    """Publish one message, and then, after a word, for some seconds. Report the number.

    Args:
        publish: Sends a message.
        seconds: How long.
        rate: Messages per second. 0 is as many as possible.
    """
    publish()  # the first message waits until the subscriber is connected
    say(ready=True)
    await_word()
    cpu_begun, begun, sent = time.process_time(), time.perf_counter(), 0
    if rate:
        for sent in range(1, int(seconds * rate) + 1):
            _sleep_until(begun + sent / rate)
            publish()
    else:
        end = begun + seconds
        while time.perf_counter() < end:
            publish()
            sent += 1
    say(sent=sent, seconds=time.perf_counter() - begun, cpu=time.process_time() - cpu_begun)
    await_word()


def call_repeatedly(call: Callable[[], object], count: int) -> None:
    """Time calls that block, and report the times."""
    times = []
    for _ in range(count + count // 10):
        begun = time.perf_counter_ns()
        call()
        times.append(time.perf_counter_ns() - begun)
    say(trips=times[count // 10 :])


def sleep_repeatedly(rate: float, seconds: float) -> None:
    """Report how late `time.sleep` in a thread of its own ends, in nanoseconds."""
    late: list[int] = []

    def run() -> None:
        period = int(1e9 / rate)
        due = time.monotonic_ns() + period
        for _ in range(int(seconds * rate)):
            time.sleep(max(0, due - time.monotonic_ns()) / 1e9)
            late.append(time.monotonic_ns() - due)
            due += (late[-1] // period + 1) * period  # as a timer, it skips periods that are over

    thread = threading.Thread(target=run)
    thread.start()
    thread.join()
    say(late=late)


def _sleep_until(due: float) -> None:
    pause = due - time.perf_counter()
    if pause > 0:
        time.sleep(pause)
