"""Link of the tree of frames: what was heard of the transform of one child in one parent."""

from __future__ import annotations

from collections import deque
from itertools import pairwise
from typing import Any

from zbot.tf2.diagnosis.problem import duration_text

_KEPT = 50  #: arrivals from which the rate is computed
#: Stamps and arrivals that differ by more than this come from different clocks: simulated or
#: recorded time, and the time of day.
OTHER_TIME_NS = 60 * 10**9
#: A listener keeps the transforms of this time, as the default of `Buffer`.
_CACHE_NS = 10 * 10**9
_SHORTEST_SILENCE_NS = 10**9
_SILENT_PERIODS = 5


def is_static(topic: str) -> bool:
    """Return whether a topic has static transforms."""
    return topic.rpartition("/")[2] == "tf_static"


class Link:
    """Transform of a child frame in a parent frame, as it was heard on one topic.

    All times are nanoseconds since the epoch.

    Args:
        parent: The parent frame, without a leading slash.
        child: The child frame, without a leading slash.
        topic: The topic of the messages, e.g. `/robot1/tf_static`.
    """

    def __init__(self, parent: str, child: str, topic: str) -> None:
        self.parent, self.child, self.topic = parent, child, topic
        self.is_static = is_static(topic)
        self.publishers: dict[str, int] = {}  #: arrival of the last message of each node
        self.count = 0
        self.first_received_ns = self.last_received_ns = 0
        self.first_stamp_ns = self.newest_stamp_ns = self.last_stamp_ns = 0
        self.sent_ns = 0  #: time at which the last message was sent, by the publisher's clock
        self.repetitions = 0  #: messages whose stamp is the same as in the message before
        self.pose_changes = 0
        self.has_slash = False  #: whether a name was published with a leading slash
        self._arrivals: deque[int] = deque(maxlen=_KEPT)
        self._pose: tuple[float, ...] = ()

    @property
    def name(self) -> str:
        """The parent and the child, e.g. `odom -> base_link`."""
        return f"{self.parent} -> {self.child}"

    def add(self, transform: Any, *, received_ns: int, sent_ns: int, publisher: str) -> None:
        """Take a `TransformStamped` of this link."""
        stamp = transform.header.stamp
        stamp_ns = stamp.sec * 10**9 + stamp.nanosec
        if not self.count or stamp_ns < self.newest_stamp_ns - _CACHE_NS:  # time was set back
            self.first_received_ns = self.first_received_ns or received_ns
            self.first_stamp_ns = self.newest_stamp_ns = stamp_ns
        elif stamp_ns == self.last_stamp_ns:
            self.repetitions += 1
        self.newest_stamp_ns = max(self.newest_stamp_ns, stamp_ns)
        self.count += 1
        self.last_stamp_ns, self.last_received_ns, self.sent_ns = stamp_ns, received_ns, sent_ns
        self._arrivals.append(received_ns)
        self.publishers[publisher] = received_ns
        if self.pose_changes < _KEPT:  # enough is known
            self._compare_pose(transform.transform)

    def _compare_pose(self, transform: Any) -> None:
        t, q = transform.translation, transform.rotation
        pose = (t.x, t.y, t.z, q.x, q.y, q.z, q.w)
        if self._pose and pose != self._pose:
            self.pose_changes += 1
        self._pose = pose

    @property
    def nodes(self) -> list[str]:
        """The full names of the nodes that publish this link, as far as they are known."""
        return sorted(name for name in self.publishers if name)

    @property
    def rate_hz(self) -> float:
        """Mean rate of the last arrivals, or 0 for fewer than two."""
        span_ns = self._arrivals[-1] - self._arrivals[0] if self._arrivals else 0
        return (len(self._arrivals) - 1) / span_ns * 1e9 if span_ns > 0 else 0.0

    @property
    def rate_text(self) -> str:
        """The rate in Hz, or an empty text if fewer than two transforms came."""
        return f"{self.rate_hz:.1f} Hz" if self.rate_hz else ""

    @property
    def longest_gap_ns(self) -> int:
        """Longest time between two of the last arrivals."""
        gaps = (later - earlier for earlier, later in pairwise(self._arrivals))
        return max(gaps, default=0)

    @property
    def oldest_stamp_ns(self) -> int:
        """Oldest stamp that a listener has kept."""
        return max(self.first_stamp_ns, self.newest_stamp_ns - _CACHE_NS)

    @property
    def lead_ns(self) -> int:
        """Time from the last arrival to its stamp. It is above 0 if the stamp is in the future."""
        return self.last_stamp_ns - self.last_received_ns

    @property
    def clock_lead_ns(self) -> int | None:
        """Lead of the publisher's clock over this machine's, or None if that is unknown.

        The time of transport makes it too small.
        """
        return self.sent_ns - self.last_received_ns if self.sent_ns else None

    @property
    def has_other_time(self) -> bool:
        """Whether the stamps have simulated or recorded time, and not the time of day."""
        lead_ns = self.lead_ns
        if self.clock_lead_ns is not None:
            lead_ns -= self.clock_lead_ns  # a wrong clock is not another kind of time
        return not self.is_static and abs(lead_ns) > OTHER_TIME_NS

    def age_text(self, now_ns: int) -> str:
        """Return the age of the newest stamp, or the stamp if it is not the time of day."""
        if self.has_other_time:
            return f"at {self.newest_stamp_ns / 1e9:.2f} s"
        return f"{duration_text(now_ns - self.newest_stamp_ns)} old"

    def silence_ns(self, now_ns: int) -> int:
        """Return the time since the last arrival."""
        return max(0, now_ns - self.last_received_ns)

    def is_stale(self, now_ns: int) -> bool:
        """Return whether the link has stopped, measured by the gaps that it had before."""
        shortest_ns = _SHORTEST_SILENCE_NS if self.count > 1 else 2 * _SHORTEST_SILENCE_NS
        limit_ns = max(shortest_ns, _SILENT_PERIODS * self.longest_gap_ns)
        return not self.is_static and self.silence_ns(now_ns) > limit_ns
