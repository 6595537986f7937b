"""Options of a playback."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping

    from zbot.bag.selection import Selection
    from zbot.qos import QoSProfile


@dataclass(frozen=True)
class PlayOptions:
    """How to play. Times of the recording are nanoseconds since the epoch."""

    selection: Selection
    rate: float = 1.0
    loops: bool = False
    delay_s: float = 0.0
    start_offset_s: float = 0.0
    duration_s: float = -1.0  #: below 0 means all
    until_ns: int = -1  #: below 0 means all
    remap: Mapping[str, str] = field(default_factory=dict)  #: other names of topics
    overrides: Mapping[str, QoSProfile] = field(default_factory=dict)
    clock_hz: float = 0.0  #: rate of `/clock`. 0 means that it is not published
    clock_topics: frozenset[str] | None = frozenset()  #: `/clock` with these topics; None: all
    is_paused: bool = False
    queue_size: int = 1000
    is_by_send_time: bool = False  #: whether the times of sending decide, not those of recording
    publishes_requests: bool = (
        False  #: whether services are called, instead of playing their events
    )
    requests_of_clients: bool = False  #: whether the events of the clients are the requests to send
    sends_goals: bool = False  #: whether the goals of actions are sent, instead of their events
    acknowledge_s: float = -1.0  #: longest wait for the subscribers at the end; 0: no limit
