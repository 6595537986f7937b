"""History of one frame: its transforms in its parent frame over time."""

from __future__ import annotations

from bisect import bisect_left, bisect_right, insort
from operator import attrgetter
from typing import TYPE_CHECKING, NamedTuple

from zbot.tf2.errors import ExtrapolationException

if TYPE_CHECKING:
    from zbot.tf2.rigid import Rigid

_BY_TIME = attrgetter("stamp_ns")


class Sample(NamedTuple):
    """Transform of a frame in its parent at one time."""

    stamp_ns: int
    parent: str
    pose: Rigid


class Frame:
    """Samples of one frame in the order of time. A static frame has one sample for all times.

    Args:
        name: Name of the frame.
        cache_ns: Age in nanoseconds at which samples are dropped, relative to the latest sample.
    """

    def __init__(self, name: str, cache_ns: int) -> None:
        self.name = name
        self.authority = ""
        self.is_static = False
        self._cache_ns = cache_ns
        self._samples: list[Sample] = []

    @property
    def newest(self) -> Sample:
        """Latest sample."""
        return self._samples[-1]

    @property
    def parent(self) -> str:
        """Parent frame in the latest sample."""
        return self._samples[-1].parent

    @property
    def latest_ns(self) -> int:
        """Time of the latest sample."""
        return self._samples[-1].stamp_ns

    @property
    def oldest_ns(self) -> int:
        """Time of the oldest sample that is kept."""
        return self._samples[0].stamp_ns

    @property
    def rate_hz(self) -> float:
        """Mean rate of the samples that are kept, or 0 for fewer than two samples."""
        span = self.latest_ns - self.oldest_ns
        return (len(self._samples) - 1) / (span / 1e9) if span else 0.0

    def add(self, sample: Sample, *, is_static: bool) -> bool:
        """Add a sample. Return `False` if it is too old, or if another sample has the same time."""
        self.is_static = is_static
        if is_static:
            self._samples = [sample]
            return True
        if self._samples and sample.stamp_ns < self.latest_ns - self._cache_ns:
            return False
        place = bisect_left(self._samples, sample.stamp_ns, key=_BY_TIME)
        if place < len(self._samples) and self._samples[place].stamp_ns == sample.stamp_ns:
            return False
        insort(self._samples, sample, key=_BY_TIME)
        oldest = self.latest_ns - self._cache_ns
        del self._samples[: bisect_left(self._samples, oldest, key=_BY_TIME)]
        return True

    def at(self, stamp_ns: int) -> Sample:
        """Return the sample at a time, interpolated between two samples.

        Raises:
            ExtrapolationException: The time is before the first or after the last sample.
        """
        if self.is_static:
            return self._samples[0]
        after = bisect_right(self._samples, stamp_ns, key=_BY_TIME)
        if after and self._samples[after - 1].stamp_ns == stamp_ns:
            return self._samples[after - 1]
        if after == 0 or after == len(self._samples):
            raise ExtrapolationException(self._outside(stamp_ns, is_future=after > 0))
        first, second = self._samples[after - 1], self._samples[after]
        if first.parent != second.parent:
            return first
        share = (stamp_ns - first.stamp_ns) / (second.stamp_ns - first.stamp_ns)
        return Sample(stamp_ns, first.parent, first.pose.towards(second.pose, share))

    def _outside(self, stamp_ns: int, *, is_future: bool) -> str:
        asked = f"Requested time {stamp_ns / 1e9:.6f}"
        if len(self._samples) == 1:
            there = f"but only time {self.latest_ns / 1e9:.6f} is in the buffer"
            return f"Lookup would require extrapolation at time. {asked} {there}"
        where, edge, stamp = (
            ("into the future", "latest", self.latest_ns)
            if is_future
            else ("into the past", "earliest", self.oldest_ns)
        )
        return (
            f"Lookup would require extrapolation {where}. {asked} but the {edge} data is at time "
            f"{stamp / 1e9:.6f}"
        )
