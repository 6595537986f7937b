"""Options to record and to play, with the names and defaults of ROS 2's `rosbag2_py`."""

from __future__ import annotations

import enum
from dataclasses import dataclass, field
from datetime import timedelta
from typing import TYPE_CHECKING

from zbot.bag import play_options as own
from zbot.bag.recorder import Discovery
from zbot.bag.selection import Selection

if TYPE_CHECKING:
    from zbot.qos import QoSProfile

_EVENT_TOPIC = "/_service_event"


class MessageOrder(enum.IntEnum):
    """Times that decide when a message is played."""

    RECEIVED_TIMESTAMP = 0
    SENT_TIMESTAMP = 1


class ServiceRequestsSource(enum.IntEnum):
    """Events that contain the requests to send: those of servers or those of clients."""

    SERVICE_INTROSPECTION = 0
    CLIENT_INTROSPECTION = 1


@dataclass
class PlayOptions:
    """How to play. Durations are in seconds, but `wait_acked_timeout` is in milliseconds.

    A `playback_duration` or `playback_until_timestamp` below 0 means no limit.
    """

    read_ahead_queue_size: int = 1000
    node_prefix: str = ""
    rate: float = 1.0
    topics_to_filter: list[str] = field(default_factory=list)
    services_to_filter: list[str] = field(default_factory=list)
    actions_to_filter: list[str] = field(default_factory=list)
    regex_to_filter: str = ""
    exclude_regex_to_filter: str = ""
    exclude_topics_to_filter: list[str] = field(default_factory=list)
    exclude_service_events_to_filter: list[str] = field(default_factory=list)
    exclude_actions_to_filter: list[str] = field(default_factory=list)
    topic_qos_profile_overrides: dict[str, QoSProfile] = field(default_factory=dict)
    loop: bool = False
    topic_remapping_options: list[str] = field(default_factory=list)
    clock_publish_frequency: float = 0.0
    clock_publish_on_topic_publish: bool = False
    clock_topics: list[str] = field(default_factory=list)
    delay: float = 0.0
    playback_duration: float = -1.0
    playback_until_timestamp: int = -1
    start_paused: bool = False
    start_offset: float = 0.0
    disable_keyboard_controls: bool = False
    wait_acked_timeout: int = -1
    disable_loan_message: bool = False
    publish_service_requests: bool = False
    service_requests_source: ServiceRequestsSource = ServiceRequestsSource.SERVICE_INTROSPECTION
    send_actions_as_client: bool = False
    message_order: MessageOrder = MessageOrder.RECEIVED_TIMESTAMP
    progress_bar_update_rate: int = 0
    progress_bar_separation_lines: int = 3

    def to_own(self) -> own.PlayOptions:
        """Return the same options for zbot's player."""
        everywhere = self.clock_publish_on_topic_publish and not self.clock_topics
        return own.PlayOptions(
            selection=_play_selection(self),
            rate=self.rate,
            loops=self.loop,
            delay_s=self.delay,
            start_offset_s=self.start_offset,
            duration_s=self.playback_duration,
            until_ns=self.playback_until_timestamp,
            remap=remap_rules(self.topic_remapping_options),
            overrides=self.topic_qos_profile_overrides,
            clock_hz=self.clock_publish_frequency,
            clock_topics=None if everywhere else frozenset(map(full_name, self.clock_topics)),
            is_paused=self.start_paused,
            queue_size=self.read_ahead_queue_size,
            is_by_send_time=self.message_order == MessageOrder.SENT_TIMESTAMP,
            publishes_requests=self.publish_service_requests,
            requests_of_clients=(
                self.service_requests_source == ServiceRequestsSource.CLIENT_INTROSPECTION
            ),
            sends_goals=self.send_actions_as_client,
            acknowledge_s=self.wait_acked_timeout / 1000,
        )


@dataclass
class RecordOptions:
    """What to record."""

    all_topics: bool = False
    all_services: bool = False
    all_actions: bool = False
    is_discovery_disabled: bool = False
    topics: list[str] = field(default_factory=list)
    topic_types: list[str] = field(default_factory=list)
    services: list[str] = field(default_factory=list)
    actions: list[str] = field(default_factory=list)
    exclude_topics: list[str] = field(default_factory=list)
    exclude_topic_types: list[str] = field(default_factory=list)
    exclude_service_events: list[str] = field(default_factory=list)
    exclude_actions: list[str] = field(default_factory=list)
    rmw_serialization_format: str = "cdr"
    topic_polling_interval: timedelta = timedelta(milliseconds=100)
    regex: str = ""
    exclude_regex: str = ""
    node_prefix: str = ""
    compression_mode: str = ""
    compression_format: str = ""
    compression_queue_size: int = 1
    compression_threads: int = 0
    compression_threads_priority: int = 0
    topic_qos_profile_overrides: dict[str, QoSProfile] = field(default_factory=dict)
    include_hidden_topics: bool = False
    include_unpublished_topics: bool = False
    start_paused: bool = False
    ignore_leaf_topics: bool = False
    use_sim_time: bool = False
    disable_keyboard_controls: bool = False

    def selection(self) -> Selection:
        """Return the rules that select topics."""
        return Selection(
            all_topics=self.all_topics,
            topics=frozenset(map(full_name, self.topics)),
            topic_types=frozenset(self.topic_types),
            regex=self.regex,
            all_services=self.all_services,
            services=_services(self.services),
            all_actions=self.all_actions,
            actions=frozenset(map(full_name, self.actions)),
            exclude_topics=frozenset(map(full_name, self.exclude_topics)),
            exclude_types=frozenset(self.exclude_topic_types),
            exclude_services=_services(self.exclude_service_events),
            exclude_actions=frozenset(map(full_name, self.exclude_actions)),
            exclude_regex=self.exclude_regex,
        )

    def discovery(self) -> Discovery:
        """Return how topics are found."""
        return Discovery(
            is_on=not self.is_discovery_disabled,
            period_s=self.topic_polling_interval.total_seconds(),
            includes_hidden=self.include_hidden_topics,
            includes_unpublished=self.include_unpublished_topics,
            ignores_leaves=self.ignore_leaf_topics,
        )


def full_name(name: str) -> str:
    """Return a name with a leading slash."""
    return name if name.startswith("/") else f"/{name}"


def remap_rules(words: list[str]) -> dict[str, str]:
    """Return the new names of topics from the words `--ros-args --remap /old:=/new`."""
    found = {}
    for word in words:
        old, separator, new = word.partition(":=")
        if separator:
            found[full_name(old)] = full_name(new)
    return found


def _services(events: list[str]) -> frozenset[str]:
    return frozenset(full_name(one).removesuffix(_EVENT_TOPIC) for one in events)


def _play_selection(options: PlayOptions) -> Selection:
    is_all = not (
        options.topics_to_filter
        or options.services_to_filter
        or options.actions_to_filter
        or options.regex_to_filter
    )
    return Selection(
        all_topics=is_all,
        topics=frozenset(map(full_name, options.topics_to_filter)),
        regex=options.regex_to_filter,
        all_services=is_all,
        services=_services(options.services_to_filter),
        all_actions=is_all,
        actions=frozenset(map(full_name, options.actions_to_filter)),
        exclude_topics=frozenset(map(full_name, options.exclude_topics_to_filter)),
        exclude_services=_services(options.exclude_service_events_to_filter),
        exclude_actions=frozenset(map(full_name, options.exclude_actions_to_filter)),
        exclude_regex=options.exclude_regex_to_filter,
    )
