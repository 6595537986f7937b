"""Conversion of bags to new bags, e.g. to merge, filter, split or compress bags."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any

from zbot.bag.errors import BagReadError, BagValueError, BagWriteError
from zbot.bag.mcap_options import PRESETS
from zbot.bag.metadata import METADATA_FILE, metadata_text
from zbot.bag.options import RecordOptions, StorageOptions
from zbot.bag.reader import Reader, merge
from zbot.bag.writer import STORAGES, writer_for
from zbot.errors import ZbotError
from zbot.text.yaml_reader import read_yaml

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from zbot.bag.metadata import BagMetadata

_RECORD_KEYS = frozenset(field.name for field in fields(RecordOptions))
_STORAGE_KEYS = frozenset(field.name for field in fields(StorageOptions))
_NUMBERS = ("max_bagfile_size", "max_bagfile_duration", "start_time_ns", "end_time_ns")


def output_options_error(path: Path, reason: str) -> BagValueError:
    """Return the error that the YAML file of `zbot bag convert` is not valid."""
    return BagValueError(f"cannot use the output options in '{path}': {reason}")


@dataclass(frozen=True)
class Output:
    """A new bag, and what it contains."""

    storage: StorageOptions
    record: RecordOptions


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
    selection = output.record.selection()
    start_ns, end_ns = max(output.storage.start_time_ns, 0), output.storage.end_time_ns
    until_ns = end_ns if end_ns >= 0 else None
    with writer_for(output.storage, output.record) as writer:
        for bag in bags:
            for name, topic in bag.topics.items():
                if selection.takes(name, topic.type_name):
                    writer.create_topic(topic, bag.definition(topic.type_name))
        topics = writer.topics
        streams = [bag.messages(topics, start_ns, until_ns) for bag in bags]
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
    values = {name: value for name, value in values.items() if value is not None}
    everything = bool(values.pop("all", False))
    if "exclude" in values:  # the name of `exclude_regex` before Jazzy
        values.setdefault("exclude_regex", values.pop("exclude"))
    values |= {name: str(values[name]) for name in ("regex", "exclude_regex") if name in values}
    unknown = sorted(set(values) - _STORAGE_KEYS - _RECORD_KEYS)
    if unknown:
        raise ValueError(f"zbot does not know the key {unknown[0]!r}")
    uri = values["uri"]
    numbers = {name: int(values[name]) for name in _NUMBERS if name in values}
    custom = {str(key): str(value) for key, value in values.get("custom_data", {}).items()}
    storage = _options(
        StorageOptions(str(uri)), values, **numbers, uri=str(uri), custom_data=custom
    )
    record = _options(RecordOptions(), values)
    if everything:
        record = replace(record, all_topics=True, all_services=True, all_actions=True)
    _check(storage, record)
    return Output(storage, record)


def _options(options: Any, values: dict[str, Any], **read: Any) -> Any:
    """Return options with the values of the YAML. `read` has the values that were converted."""
    names = {field.name for field in fields(options)} & set(values)
    return replace(options, **{name: values[name] for name in names} | read)


def _check(storage: StorageOptions, record: RecordOptions) -> None:
    if storage.storage_id not in {"", *STORAGES}:
        raise ValueError(f"storage_id cannot be {storage.storage_id!r}: choose mcap or sqlite3")
    mode = str(record.compression_mode)
    if mode.lower() not in {"", "none", "file", "message"}:
        raise ValueError(f"compression_mode cannot be {mode!r}: choose none, file or message")
    if record.compression_format not in {"", "zstd"}:
        raise ValueError("compression_format can only be zstd")
    preset = storage.storage_preset_profile
    if preset not in {"", *PRESETS}:
        raise ValueError(f"storage_preset_profile cannot be {preset!r}: choose one of {PRESETS}")
    record.selection()  # the regular expressions must be valid
