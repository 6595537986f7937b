"""Options to record, to play and to store, with the names of ROS 2's `rosbag2_py`."""

from __future__ import annotations

import enum
from dataclasses import dataclass, field
from datetime import timedelta
from typing import TYPE_CHECKING

from zbot.bag.selection import Selection

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.qos import QoSProfile

_EVENT_TOPIC = "/_service_event"
MAX_CACHE_BYTES = 100 * 2**20  #: default of `ros2 bag record`


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

    def selection(self) -> Selection:
        """Return the rules that select topics."""
        return Selection.narrowed(
            topics=names(self.topics_to_filter),
            services=_services(self.services_to_filter),
            actions=names(self.actions_to_filter),
            regex=self.regex_to_filter,
            exclude_topics=names(self.exclude_topics_to_filter),
            exclude_services=_services(self.exclude_service_events_to_filter),
            exclude_actions=names(self.exclude_actions_to_filter),
            exclude_regex=self.exclude_regex_to_filter,
        )

    def remap(self, name: str) -> str:
        """Return the new name of a topic."""
        for rule in reversed(self.topic_remapping_options):
            old, separator, new = rule.partition(":=")
            if separator and full_name(old) == name:
                return full_name(new)
        return name

    @property
    def topics_with_clock(self) -> frozenset[str] | None:
        """The topics before whose messages `/clock` is published. `None` means all topics."""
        is_all = self.clock_publish_on_topic_publish and not self.clock_topics
        return None if is_all else names(self.clock_topics)

    @property
    def requests_of_clients(self) -> bool:
        """Whether to send the requests of clients' events."""
        return self.service_requests_source == ServiceRequestsSource.CLIENT_INTROSPECTION


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
            topics=names(self.topics),
            topic_types=frozenset(self.topic_types),
            regex=self.regex,
            all_services=self.all_services,
            services=_services(self.services),
            all_actions=self.all_actions,
            actions=names(self.actions),
            exclude_topics=names(self.exclude_topics),
            exclude_types=frozenset(self.exclude_topic_types),
            exclude_services=_services(self.exclude_service_events),
            exclude_actions=names(self.exclude_actions),
            exclude_regex=self.exclude_regex,
        )

    @classmethod
    def everything(cls) -> RecordOptions:
        """Return the options to record all topics, services and actions."""
        return cls(all_topics=True, all_services=True, all_actions=True)


@dataclass
class StorageOptions:
    """Where and how a bag is stored."""

    uri: str
    storage_id: str = ""
    max_bagfile_size: int = 0
    max_bagfile_duration: int = 0
    max_cache_size: int = 0  #: bytes that may wait for the disk; 0 means no limit
    storage_preset_profile: str = ""
    storage_config_uri: str = ""
    snapshot_mode: bool = False
    start_time_ns: int = -1
    end_time_ns: int = -1
    custom_data: dict[str, str] = field(default_factory=dict)
    max_cache_duration: int = 0  #: seconds that `snapshot_mode` keeps; 0 means no limit
    repeat_latched: bool = False  #: whether each file begins with the latched messages


def full_name(name: str) -> str:
    """Return a name with a leading slash."""
    return name if name.startswith("/") else f"/{name}"


def names(words: Iterable[str]) -> frozenset[str]:
    """Return names with leading slashes."""
    return frozenset(map(full_name, words))


def _services(events: Iterable[str]) -> frozenset[str]:
    return frozenset(full_name(event).removesuffix(_EVENT_TOPIC) for event in events)
