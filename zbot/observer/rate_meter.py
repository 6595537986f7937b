"""Meter of messages and bytes a second over the last 5 s, with constant memory."""

from __future__ import annotations

import threading
from collections import deque
from dataclasses import dataclass

_WINDOW_NS = 5 * 10**9
_BUCKET_NS = 10**8
#: The rate falls after this many periods without a message: the publisher is slower or has ended.
_SILENT_PERIODS = 2


@dataclass(slots=True)
class _Bucket:
    first_ns: int
    last_ns: int
    count: int
    size: int


class RateMeter:
    """Meter of arrivals. Different threads may call `add` and `rates`.

    Times are in nanoseconds. They come from one clock that does not run backwards.
    """

    def __init__(self) -> None:
        self._buckets: deque[_Bucket] = deque(maxlen=_WINDOW_NS // _BUCKET_NS)
        self._lock = threading.Lock()

    def add(self, now_ns: int, size: int) -> None:
        """Count an arrival of a message with a size in bytes."""
        with self._lock:
            bucket = self._buckets[-1] if self._buckets else None
            if bucket is None or now_ns - bucket.first_ns >= _BUCKET_NS:
                self._buckets.append(_Bucket(now_ns, now_ns, 1, size))
                return
            bucket.last_ns = now_ns
            bucket.count += 1
            bucket.size += size

    def rates(self, now_ns: int) -> tuple[float, float]:
        """Return arrivals and bytes a second. Both are 0 for fewer than two arrivals in 5 s."""
        with self._lock:
            recent = [bucket for bucket in self._buckets if now_ns - bucket.last_ns <= _WINDOW_NS]
        count = sum(bucket.count for bucket in recent)
        if count < 2:
            return 0.0, 0.0
        span_ns = recent[-1].last_ns - recent[0].first_ns
        silent_ns = now_ns - recent[-1].last_ns
        if silent_ns * (count - 1) > _SILENT_PERIODS * span_ns:
            span_ns += silent_ns
        if span_ns <= 0:
            return 0.0, 0.0
        rate_hz = (count - 1) / span_ns * 1e9
        return rate_hz, rate_hz * sum(bucket.size for bucket in recent) / count
