"""Options, filters and descriptions of bags, with the names that ROS 2's `rosbag2_py` has."""

from __future__ import annotations

import enum
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from zbot.bag import metadata as own
from zbot.bag.qos_profiles import read_profiles
from zbot.bag.selection import Selection
from zbot.time import Duration, Time

if TYPE_CHECKING:
    from zbot.qos import QoSProfile


@dataclass
class ConverterOptions:
    """Serialization of the messages. The serialization is always `cdr`."""

    input_serialization_format: str = ""
    output_serialization_format: str = ""


class CompressionMode(enum.IntEnum):
    """Parts of a bag that are compressed: nothing, whole files or single messages."""

    NONE = 0
    FILE = 1
    MESSAGE = 2


@dataclass
class CompressionOptions:
    """How files are compressed. The format is always `zstd`."""

    compression_format: str = ""
    compression_mode: CompressionMode = CompressionMode.NONE
    compression_queue_size: int = 0
    compression_threads: int = 0


class ReadOrderSortBy(enum.IntEnum):
    """Times that decide the order of messages."""

    ReceivedTimestamp = 0
    PublishedTimestamp = 1
    File = 2


@dataclass
class ReadOrder:
    """Order of messages."""

    sort_by: ReadOrderSortBy = ReadOrderSortBy.ReceivedTimestamp
    reverse: bool = False


def compression_mode_from_string(text: str) -> CompressionMode:
    """Return the mode with a name in any case. An unknown name is `NONE`."""
    return CompressionMode.__members__.get(text.upper(), CompressionMode.NONE)


def compression_mode_to_string(mode: CompressionMode) -> str:
    """Return the name of a mode in capital letters."""
    return CompressionMode(mode).name


def to_rclcpp_qos_vector(text: str, version: int) -> list[QoSProfile]:  # noqa: ARG001 - rosbag2's signature
    """Return the profiles in the YAML of a bag."""
    return read_profiles(text)


def convert_rclcpp_qos_to_rclpy_qos(profile: QoSProfile) -> QoSProfile:
    """Return the profile itself, because zbot has only one class of profiles."""
    return profile


@dataclass
class StorageFilter:
    """Topics to read. Without names and `regex`, everything that is not excluded is read."""

    topics: list[str] = field(default_factory=list)
    services_events: list[str] = field(default_factory=list)
    actions: list[str] = field(default_factory=list)
    regex: str = ""
    exclude_topics: list[str] = field(default_factory=list)
    exclude_service_events: list[str] = field(default_factory=list)
    exclude_actions: list[str] = field(default_factory=list)
    regex_to_exclude: str = ""

    def selection(self) -> Selection:
        """Return the same rules for zbot's readers."""
        return Selection.narrowed(
            topics=frozenset(self.topics),
            services=_services(self.services_events),
            actions=frozenset(self.actions),
            regex=self.regex,
            exclude_topics=frozenset(self.exclude_topics),
            exclude_services=_services(self.exclude_service_events),
            exclude_actions=frozenset(self.exclude_actions),
            exclude_regex=self.regex_to_exclude,
        )


def _services(events: list[str]) -> frozenset[str]:
    return frozenset(event.removesuffix("/_service_event") for event in events)


@dataclass
class TopicMetadata:
    """A topic of a bag."""

    id: int
    name: str
    type: str
    serialization_format: str
    offered_qos_profiles: list[QoSProfile] = field(default_factory=list)
    type_description_hash: str = ""

    def equals(self, other: TopicMetadata) -> bool:
        """Return whether another topic is the same. The ids may differ."""
        return to_own_topic(self) == to_own_topic(other)


@dataclass
class TopicInformation:
    """A topic of a bag, and the number of its messages."""

    topic_metadata: TopicMetadata
    message_count: int


@dataclass
class FileInformation:
    """A file of a bag."""

    path: str
    starting_time: Time
    duration: Duration
    message_count: int


@dataclass
class MessageDefinition:
    """Definition of a message type in a bag."""

    topic_type: str
    encoding: str
    encoded_message_definition: str
    type_hash: str


@dataclass
class BagMetadata:
    """Description of a bag."""

    version: int = own.VERSION
    bag_size: int = 0
    storage_identifier: str = ""
    relative_file_paths: list[str] = field(default_factory=list)
    files: list[FileInformation] = field(default_factory=list)
    duration: Duration = field(default_factory=Duration)
    starting_time: Time = field(default_factory=Time)
    message_count: int = 0
    topics_with_message_count: list[TopicInformation] = field(default_factory=list)
    compression_format: str = ""
    compression_mode: str = ""
    custom_data: dict[str, str] = field(default_factory=dict)
    ros_distro: str = ""


def to_own_topic(topic: TopicMetadata) -> own.TopicMetadata:
    """Return a topic in zbot's form."""
    return own.TopicMetadata(
        topic.name,
        topic.type,
        topic.serialization_format,
        tuple(topic.offered_qos_profiles),
        topic.type_description_hash,
    )


def topic_metadata(number: int, topic: own.TopicMetadata) -> TopicMetadata:
    """Return a topic in rosbag2_py's form."""
    return TopicMetadata(
        number,
        topic.name,
        topic.type_name,
        topic.serialization_format,
        list(topic.offered_qos_profiles),
        topic.type_hash,
    )


def bag_metadata(found: own.BagMetadata) -> BagMetadata:
    """Return a description in rosbag2_py's form."""
    return BagMetadata(
        version=found.version,
        bag_size=found.bag_size,
        storage_identifier=found.storage_id,
        relative_file_paths=list(found.paths),
        files=[
            FileInformation(
                file.path,
                Time(nanoseconds=file.start_ns),
                Duration(nanoseconds=file.duration_ns),
                file.message_count,
            )
            for file in found.files
        ],
        duration=Duration(nanoseconds=found.duration_ns),
        starting_time=Time(nanoseconds=found.start_ns),
        message_count=found.message_count,
        topics_with_message_count=[
            TopicInformation(topic_metadata(number, topic.topic), topic.message_count)
            for number, topic in enumerate(found.topics, 1)
        ],
        compression_format=found.compression_format,
        compression_mode=found.compression_mode,
        custom_data=dict(found.custom_data),
        ros_distro=found.ros_distro,
    )


def to_own_metadata(given: BagMetadata) -> own.BagMetadata:
    """Return a description in zbot's form."""
    return own.BagMetadata(
        storage_id=given.storage_identifier,
        topics=tuple(
            own.TopicInformation(
                to_own_topic(information.topic_metadata), information.message_count
            )
            for information in given.topics_with_message_count
        ),
        files=tuple(
            own.FileInformation(
                file.path,
                file.starting_time.nanoseconds,
                file.duration.nanoseconds,
                file.message_count,
            )
            for file in given.files
        ),
        paths=tuple(given.relative_file_paths),
        start_ns=given.starting_time.nanoseconds,
        duration_ns=given.duration.nanoseconds,
        message_count=given.message_count,
        compression_format=given.compression_format,
        compression_mode=given.compression_mode,
        custom_data=dict(given.custom_data),
        ros_distro=given.ros_distro,
        version=given.version,
        bag_size=given.bag_size,
    )
