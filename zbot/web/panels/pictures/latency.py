"""Latency of pictures: the time from the stamp in the header to the arrival at the page."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.tf2.diagnosis.problem import duration_text

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot

_CLOCK = "/clock"
#: A stamp may be this much in the future, because clocks are not exact.
_SLACK_NS = 5_000_000
#: No picture is on its way for so long. The clock of its machine is another one.
_LONGEST_NS = 60 * 10**9


def has_simulated_time(graph: Snapshot) -> bool:
    """Return whether a node publishes the time, so that stamps are not times of this machine."""
    return bool(graph.publishers(_CLOCK))


def latency_text(message: Any, received_ns: int, *, is_simulated: bool) -> str:
    """Return the latency, or why it is not known.

    Args:
        message: The message.
        received_ns: Its time of arrival, in nanoseconds since the epoch.
        is_simulated: Whether the stamp is simulated time.
    """
    header = getattr(message, "header", None)
    if header is None:
        return "no header"
    stamp_ns = header.stamp.sec * 10**9 + header.stamp.nanosec
    if not stamp_ns:
        return "no time stamp"
    if is_simulated:
        return "simulated time"
    late_ns = received_ns - stamp_ns
    if late_ns < -_SLACK_NS:
        return f"its clock is {duration_text(-late_ns)} ahead"
    if late_ns > _LONGEST_NS:
        return f"its clock is {duration_text(late_ns)} behind"
    return f"latency {duration_text(max(0, late_ns))}"
