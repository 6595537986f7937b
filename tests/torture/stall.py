"""Meter of how slow the machine is at a moment, to extend limits of time on a busy machine.

A process of its own measures it, so that the work of the program that asks does not count. On a
quiet machine, the limits stay as they are.
"""

from __future__ import annotations

import subprocess
import sys
import threading
import time
from collections import deque
from typing import NamedTuple

_PROBE = """
import time
while True:
    begin = time.monotonic()
    time.sleep(0.1)
    late = time.monotonic() - begin - 0.1
    wall, used = time.monotonic(), time.thread_time()
    while time.thread_time() - used < 0.005:
        pass
    print(late, (time.monotonic() - wall) / (time.thread_time() - used), flush=True)
"""
_KEPT = 100_000  # samples, for about three hours
_BEFORE_S = 1.0  # samples of this time before the begin count, too


class _Sample(NamedTuple):
    time: float
    late_s: float  #: how long a thread that was ready had to wait
    slowdown: float  #: how many times as long some work took


class StallMeter:
    """Meter of the machine's speed, from `__enter__` to `__exit__`."""

    def __init__(self) -> None:
        self._samples: deque[_Sample] = deque(maxlen=_KEPT)

    def __enter__(self) -> StallMeter:
        words = [sys.executable, "-c", _PROBE]
        self._process = subprocess.Popen(
            words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
        )
        self._reader = threading.Thread(target=self._read)
        self._reader.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._process.kill()
        self._process.wait()
        self._reader.join()

    def _read(self) -> None:
        assert self._process.stdout is not None
        with self._process.stdout as lines:
            for line in lines:
                words = line.split()
                if line.endswith("\n") and len(words) == 2:  # the last line may be cut
                    late_s, slowdown = map(float, words)
                    self._samples.append(_Sample(time.monotonic(), late_s, slowdown))

    def allowed(self, limit_s: float, begin: float) -> float:
        """Return a limit in seconds for something that began at a monotonic time.

        It is the limit of a quiet machine, times the mean slowdown since the begin, plus the
        longest time for which a ready thread had to wait.
        """
        samples = [sample for sample in tuple(self._samples) if sample.time >= begin - _BEFORE_S]
        if not samples:
            return limit_s
        slowdown = sum(sample.slowdown for sample in samples) / len(samples)
        return limit_s * max(1.0, slowdown) + max(sample.late_s for sample in samples)

    def mean_slowdown(self) -> float:
        """Return the mean slowdown of all samples. It is 1 on a quiet machine."""
        samples = tuple(self._samples)
        return sum(sample.slowdown for sample in samples) / len(samples) if samples else 1.0
