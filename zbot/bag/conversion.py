"""Conversion of bags to new bags, e.g. to merge, filter, split or compress bags."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from zbot.bag.errors import BagReadError, BagValueError, BagWriteError
from zbot.bag.mcap_options import PRESETS
from zbot.bag.metadata import METADATA_FILE, metadata_text
from zbot.bag.reader import Reader, merge
from zbot.bag.selection import Selection
from zbot.bag.writer import STORAGES, Writer
from zbot.errors import ZbotError
from zbot.yaml_reader import read_yaml

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.bag.metadata import BagMetadata

_LISTS = {
    "topics": "topics",
    "topic_types": "topic_types",
    "services": "services",
    "actions": "actions",
    "exclude_topics": "exclude_topics",
    "exclude_topic_types": "exclude_types",
    "exclude_service_events": "exclude_services",
    "exclude_actions": "exclude_actions",
}
_WORDS = ("regex", "exclude_regex")
# Keys of rosbag2 that are allowed, but have no effect in zbot.
_WITHOUT_EFFECT = frozenset(
    {
        "compression_queue_size",
        "compression_threads",
        "compression_threads_priority",
        "ignore_leaf_topics",
        "include_hidden_topics",
        "include_unpublished_topics",
        "is_discovery_disabled",
        "max_cache_size",
        "rmw_serialization_format",
        "storage_config_uri",
    }
)


def output_options_error(path: Path, reason: str) -> BagValueError:
    """Return the error that the YAML file of `zbot bag convert` is not valid."""
    return BagValueError(f"cannot use the output options in '{path}': {reason}")


@dataclass(frozen=True)
class Output:
    """A new bag, and what it contains. Times are nanoseconds since the epoch."""

    path: Path
    selection: Selection
    options: dict[str, Any] = field(default_factory=dict)  #: arguments of `Writer`
    start_ns: int = 0
    end_ns: int | None = None


def read_outputs(path: Path) -> list[Output]:
    """Return the new bags in a YAML file with rosbag2's key `output_bags`.

    Raises:
        BagValueError: The file cannot be read or is not valid.
    """
    try:
        found = read_yaml(path.read_text(encoding="utf-8"))
        outputs = list(map(_read_output, found["output_bags"]))
    except OSError as error:
        raise output_options_error(path, error.strerror or str(error)) from error
    except (AttributeError, KeyError, TypeError):
        raise output_options_error(path, "the key output_bags has no list of bags") from None
    except (ZbotError, ValueError) as error:
        raise output_options_error(path, str(error)) from error
    if not outputs:
        raise output_options_error(path, "there is no bag in output_bags")
    return outputs


def convert(bags: Sequence[Reader], output: Output) -> int:
    """Write a new bag with the messages of other bags. Return the number of messages.

    Raises:
        BagExistsError: The new bag exists.
        BagReadError: A part of a bag is damaged.
        BagWriteError: The new bag cannot be written, e.g. because the disk is full.
    """
    with Writer(output.path, **output.options) as writer:
        for bag in bags:
            for name, topic in bag.topics.items():
                if output.selection.takes(name, topic.type_name):
                    writer.create_topic(topic, bag.definition(topic.type_name))
        topics = writer.topics
        streams = [bag.messages(topics, output.start_ns, output.end_ns) for bag in bags]
        for message in merge(streams):
            writer.write_serialized(*message)
        return writer.message_count


def reindex(folder: Path) -> BagMetadata:
    """Write `metadata.yaml` again from the files of a bag. Return its contents.

    Raises:
        BagReadError: A file cannot be read, or the folder has no files of a bag.
        BagWriteError: `metadata.yaml` cannot be written.
    """
    if not folder.is_dir():
        raise BagReadError(folder, "Must specify a bag directory")
    with Reader(folder, uses_metadata_file=False) as bag:
        metadata = bag.metadata
    try:
        text = metadata_text(metadata)
        (folder / METADATA_FILE).write_text(text, encoding="utf-8")
    except OSError as error:
        raise BagWriteError(folder, error.strerror or str(error)) from error
    return metadata


def _read_output(values: dict[str, Any]) -> Output:
    values = dict(values)
    output = Output(
        path=Path(str(values.pop("uri"))),
        selection=_selection(values),
        start_ns=max(int(values.pop("start_time_ns", 0)), 0),
    )
    end_ns = int(values.pop("end_time_ns", -1))
    storage = values.pop("storage_id", "") or "mcap"
    if storage not in STORAGES:
        raise ValueError(f"storage_id cannot be {storage!r}: choose mcap or sqlite3")
    mode = str(values.pop("compression_mode", "none")).lower()
    if mode not in {"", "none", "file", "message"}:
        raise ValueError(f"compression_mode cannot be {mode!r}: choose none, file or message")
    if values.pop("compression_format", "") not in {"", "zstd", None}:
        raise ValueError("compression_format can only be zstd")
    preset = values.pop("storage_preset_profile", "") or "zstd"
    if preset not in PRESETS:
        raise ValueError(f"storage_preset_profile cannot be {preset!r}: choose one of {PRESETS}")
    options = {
        "storage_id": storage,
        "preset": preset,
        "compress_files": mode == "file",
        "compress_messages": mode == "message",
        "max_bytes": int(values.pop("max_bagfile_size", 0)),
        "max_duration_s": int(values.pop("max_bagfile_duration", 0)),
        "custom_data": {str(k): str(v) for k, v in (values.pop("custom_data", None) or {}).items()},
    }
    unknown = sorted(set(values) - _WITHOUT_EFFECT)
    if unknown:
        raise ValueError(f"zbot does not know the key {unknown[0]!r}")
    return replace(output, options=options, end_ns=end_ns if end_ns >= 0 else None)


def _selection(values: dict[str, Any]) -> Selection:
    everything = bool(values.pop("all", False))
    rules: dict[str, Any] = {
        new: frozenset(values.pop(old, None) or ()) for old, new in _LISTS.items()
    }
    if "exclude" in values:  # the name of `exclude_regex` before Jazzy
        values.setdefault("exclude_regex", values.pop("exclude"))
    rules |= {name: str(values.pop(name, "") or "") for name in _WORDS}
    return Selection(
        all_topics=bool(values.pop("all_topics", False)) or everything,
        all_services=bool(values.pop("all_services", False)) or everything,
        all_actions=bool(values.pop("all_actions", False)) or everything,
        **rules,
    )
