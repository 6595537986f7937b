"""Description of a bag: its files, topics, times and counts, as in `metadata.yaml`."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from zbot.bag.errors import BagReadError
from zbot.bag.qos_profiles import profile_values, read_profiles
from zbot.text.yaml_reader import YamlError, read_yaml

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

    from zbot.qos import QoSProfile

METADATA_FILE = "metadata.yaml"
VERSION = 9  #: rosbag2's version of the format, since Jazzy
_ROOT = "rosbag2_bagfile_information"


@dataclass(frozen=True)
class TopicMetadata:
    """A topic of a bag."""

    name: str
    type_name: str  #: `std_msgs/msg/String`
    serialization_format: str = "cdr"
    offered_qos_profiles: tuple[QoSProfile, ...] = ()  #: profiles of the publishers
    type_hash: str = ""  #: `RIHS01_...`, or empty if the bag does not have it


@dataclass(frozen=True)
class TopicInformation:
    """A topic of a bag and the number of its messages."""

    topic: TopicMetadata
    message_count: int


@dataclass(frozen=True)
class FileInformation:
    """A file of a bag. Times are in nanoseconds. `start_ns` counts from the epoch."""

    path: str
    start_ns: int
    duration_ns: int
    message_count: int


@dataclass(frozen=True)
class BagMetadata:
    """A bag's description. Times are in nanoseconds. `start_ns` counts from the epoch."""

    storage_id: str
    topics: tuple[TopicInformation, ...] = ()
    files: tuple[FileInformation, ...] = ()
    paths: tuple[str, ...] = ()  #: paths of the files, relative to the bag's folder
    start_ns: int = 0
    duration_ns: int = 0
    message_count: int = 0
    compression_format: str = ""
    compression_mode: str = ""
    custom_data: dict[str, str] = field(default_factory=dict)
    ros_distro: str = ""
    version: int = VERSION
    bag_size: int = 0  #: bytes of all files; `metadata.yaml` does not have this number

    @property
    def end_ns(self) -> int:
        """Time of the last message, in nanoseconds since the epoch."""
        return self.start_ns + self.duration_ns


def merged(parts: Iterable[BagMetadata]) -> BagMetadata:
    """Return the description of a bag from the descriptions of its files, in the files' order."""
    all_parts = list(parts)
    filled = [part for part in all_parts if part.message_count]
    start = min((part.start_ns for part in filled), default=0)
    end = max((part.end_ns for part in filled), default=0)
    topics: dict[str, TopicInformation] = {}
    for part in all_parts:
        for information in part.topics:
            known = topics.get(information.topic.name)
            count = information.message_count + (known.message_count if known else 0)
            topics[information.topic.name] = TopicInformation(
                known.topic if known else information.topic, count
            )
    return BagMetadata(
        storage_id=all_parts[0].storage_id,
        topics=tuple(topics.values()),
        files=tuple(file for part in all_parts for file in part.files),
        paths=tuple(path for part in all_parts for path in part.paths),
        start_ns=start,
        duration_ns=end - start,
        message_count=sum(part.message_count for part in all_parts),
        compression_format=all_parts[0].compression_format,
        compression_mode=all_parts[0].compression_mode,
        custom_data=all_parts[-1].custom_data,
        ros_distro=all_parts[-1].ros_distro,
        bag_size=sum(part.bag_size for part in all_parts),
    )


def metadata_values(metadata: BagMetadata) -> dict[str, Any]:
    """Return a description as the map that rosbag2 writes."""
    return {
        "version": VERSION,
        "storage_identifier": metadata.storage_id,
        "duration": {"nanoseconds": metadata.duration_ns},
        "starting_time": {"nanoseconds_since_epoch": metadata.start_ns},
        "message_count": metadata.message_count,
        "topics_with_message_count": list(map(_topic_values, metadata.topics)),
        "compression_format": metadata.compression_format,
        "compression_mode": metadata.compression_mode,
        "relative_file_paths": list(metadata.paths),
        "files": [
            {
                "path": file.path,
                "starting_time": {"nanoseconds_since_epoch": file.start_ns},
                "duration": {"nanoseconds": file.duration_ns},
                "message_count": file.message_count,
            }
            for file in metadata.files
        ],
        "custom_data": dict(metadata.custom_data),
        "ros_distro": metadata.ros_distro,
    }


def metadata_text(metadata: BagMetadata, *, root: bool = True) -> str:
    """Return a description as YAML. If `root` is true, add the top key of `metadata.yaml`."""
    import yaml  # noqa: PLC0415 - takes 15 ms

    class Dumper(yaml.SafeDumper):
        def ignore_aliases(self, data: Any) -> bool:  # noqa: ARG002 - PyYAML's signature
            return True

    values = metadata_values(metadata)
    text: str = yaml.dump({_ROOT: values} if root else values, Dumper=Dumper, sort_keys=False)
    return text


def read_metadata_file(folder: Path) -> BagMetadata:
    """Return the description in a folder's `metadata.yaml`, of any version of rosbag2.

    Raises:
        BagReadError: The file cannot be read or is not a bag's description.
    """
    path = folder / METADATA_FILE
    try:
        return read_metadata(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise BagReadError(path, error.strerror or str(error)) from error
    except UnicodeDecodeError:
        raise BagReadError(path, "it is not UTF-8 text") from None
    except YamlError as error:
        raise BagReadError(path, str(error)) from error
    except (AttributeError, KeyError, TypeError, ValueError) as error:
        reason = f"it is not a bag's metadata: {type(error).__name__}: {error}"
        raise BagReadError(path, f"{reason}; `zbot bag reindex` writes it again") from error


def read_metadata(text: str) -> BagMetadata:
    """Return the description in the YAML of `metadata.yaml`.

    Raises:
        YamlError: The text is not YAML.
        ValueError: The text is not a bag's description. The error may also be an `AttributeError`,
            a `KeyError` or a `TypeError`.
    """
    found = read_yaml(text)
    values = found.get(_ROOT, found)
    return BagMetadata(
        storage_id=str(values["storage_identifier"]),
        topics=_read_topics(values["topics_with_message_count"] or ()),
        files=tuple(map(_read_file, values.get("files") or ())),
        paths=tuple(map(str, values["relative_file_paths"] or ())),
        start_ns=int(values["starting_time"]["nanoseconds_since_epoch"]),
        duration_ns=int(values["duration"]["nanoseconds"]),
        message_count=int(values["message_count"]),
        compression_format=str(values.get("compression_format") or ""),
        compression_mode=str(values.get("compression_mode") or ""),
        custom_data={str(k): str(v) for k, v in (values.get("custom_data") or {}).items()},
        ros_distro=str(values.get("ros_distro") or ""),
        version=int(values["version"]),
    )


def _topic_values(information: TopicInformation) -> dict[str, Any]:
    topic = information.topic
    return {
        "topic_metadata": {
            "name": topic.name,
            "type": topic.type_name,
            "serialization_format": topic.serialization_format,
            "offered_qos_profiles": list(map(profile_values, topic.offered_qos_profiles)),
            "type_description_hash": topic.type_hash,
        },
        "message_count": information.message_count,
    }


def _read_topics(topics: Iterable[dict[str, Any]]) -> tuple[TopicInformation, ...]:
    # Aliases of YAML are the same object. Their profiles are read once: they can be very long.
    profiles: dict[int, tuple[QoSProfile, ...]] = {}
    return tuple(_read_topic(values, profiles) for values in topics)


def _read_topic(
    values: dict[str, Any], profiles: dict[int, tuple[QoSProfile, ...]]
) -> TopicInformation:
    topic = values["topic_metadata"]
    offered = topic.get("offered_qos_profiles")
    if id(offered) not in profiles:
        profiles[id(offered)] = tuple(read_profiles(offered))
    return TopicInformation(
        TopicMetadata(
            name=str(topic["name"]),
            type_name=str(topic["type"]),
            serialization_format=str(topic["serialization_format"]),
            offered_qos_profiles=profiles[id(offered)],
            type_hash=str(topic.get("type_description_hash") or ""),
        ),
        int(values["message_count"]),
    )


def _read_file(values: dict[str, Any]) -> FileInformation:
    return FileInformation(
        path=str(values["path"]),
        start_ns=int(values["starting_time"]["nanoseconds_since_epoch"]),
        duration_ns=int(values["duration"]["nanoseconds"]),
        message_count=int(values["message_count"]),
    )


class RecordedPart:
    """Counts and times of the messages in one file of a bag.

    Args:
        storage_id: `mcap` or `sqlite3`.
        path: The file.
    """

    def __init__(self, storage_id: str, path: Path) -> None:
        self._storage_id = storage_id
        self._name = path.name
        self._topics: dict[str, TopicMetadata] = {}
        self._counts: dict[str, int] = {}
        self.count = 0  #: messages in the file
        self.start_ns = 0  #: time of the first message
        self._end_ns = 0

    def add_topic(self, topic: TopicMetadata) -> None:
        """Add a topic without messages."""
        self._topics[topic.name] = topic
        self._counts[topic.name] = 0

    def add_message(self, topic: str, log_ns: int) -> None:
        """Count a message. The time is nanoseconds since the epoch."""
        self.start_ns = min(log_ns, self.start_ns) if self.count else log_ns
        self._end_ns = max(log_ns, self._end_ns)
        self.count += 1
        self._counts[topic] += 1

    def metadata(self, custom_data: dict[str, str], ros_distro: str) -> BagMetadata:
        """Return the description of the file."""
        duration_ns = self._end_ns - self.start_ns
        file = FileInformation(self._name, self.start_ns, duration_ns, self.count)
        return BagMetadata(
            storage_id=self._storage_id,
            topics=tuple(
                TopicInformation(topic, self._counts[name]) for name, topic in self._topics.items()
            ),
            files=(file,),
            paths=(self._name,),
            start_ns=self.start_ns,
            duration_ns=duration_ns,
            message_count=self.count,
            custom_data=custom_data,
            ros_distro=ros_distro,
        )
