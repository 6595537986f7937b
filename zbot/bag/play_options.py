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
    remap: Mapping[str, str] = field(default_factory=dict)  #: new names of topics
    overrides: Mapping[str, QoSProfile] = field(default_factory=dict)
    clock_hz: float = 0.0  #: rate of `/clock`. If it is 0, only `clock_topics` counts
    #: topics; before each message of these topics, `/clock` is published. `None` means all topics
    clock_topics: frozenset[str] | None = frozenset()
    is_paused: bool = False
    queue_size: int = 1000
    is_by_send_time: bool = False  #: whether to play by the times of sending, not of recording
    publishes_requests: bool = (
        False  #: whether to call services, instead of publishing their events
    )
    requests_of_clients: bool = False  #: whether to send requests of clients' events
    sends_goals: bool = False  #: whether to send goals, instead of actions' events
    acknowledge_s: float = -1.0  #: longest wait for subscribers. 0: no limit. Below 0: no wait
