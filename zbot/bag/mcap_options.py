"""Options of MCAP files: presets, and the keys of rosbag2's `--storage-config-file`."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from zbot.bag.errors import BagValueError
from zbot.errors import ZbotError
from zbot.text.yaml_reader import read_yaml

if TYPE_CHECKING:
    from pathlib import Path

PRESETS = ("zstd", "none", "fastwrite", "zstd_fast", "zstd_small")
COMPRESSIONS = ("zstd", "lz4", "none")
_MIN_CHUNK_BYTES, _MAX_CHUNK_BYTES = 1024, 2**28
# Keys of rosbag2 that have no counterpart in the library `mcap`.
_WITHOUT_EFFECT = frozenset(
    {
        "compressionLevel",
        "forceCompression",
        "noAttachmentCRC",
        "noAttachmentIndex",
        "noChunkIndex",
        "noMetadataIndex",
        "noSummaryCRC",
    }
)
#: Keys of rosbag2 that switch something off, and the fields that switch the same thing on.
_NEGATIVE = {
    "noChunkCRC": "has_crcs",
    "noChunking": "uses_chunks",
    "noMessageIndex": "has_message_index",
    "noStatistics": "has_statistics",
    "noSummaryOffsets": "has_summary_offsets",
    "noRepeatedChannels": "repeats_channels",
    "noRepeatedSchemas": "repeats_schemas",
}


def storage_config_error(path: Path, reason: str) -> BagValueError:
    """Return the error that a file of `--storage-config-file` is not valid."""
    return BagValueError(f"cannot use the storage options in '{path}': {reason}")


@dataclass(frozen=True)
class McapOptions:
    """Options of an MCAP file."""

    compression: str = "zstd"  #: one of `COMPRESSIONS`
    chunk_bytes: int = 2**20  #: bytes of the messages in a chunk, before compression
    uses_chunks: bool = True
    has_crcs: bool = True
    has_data_crc: bool = False
    has_message_index: bool = True
    has_statistics: bool = True
    has_summary_offsets: bool = True
    repeats_channels: bool = True
    repeats_schemas: bool = True


def preset_options(preset: str) -> McapOptions:
    """Return the options of a preset in `PRESETS`."""
    options = McapOptions(compression="zstd" if preset.startswith("zstd") else "none")
    if preset == "fastwrite":
        return replace(options, uses_chunks=False)
    if preset == "zstd_fast":
        return replace(options, has_crcs=False)
    return replace(options, chunk_bytes=4 * 2**20) if preset == "zstd_small" else options


def read_storage_config(path: Path, preset: str) -> McapOptions:
    """Return the options of a preset, with the changes in a YAML file.

    Raises:
        BagValueError: The file cannot be read, or has a wrong key or value.
    """
    try:
        values = read_yaml(path.read_text(encoding="utf-8")) or {}
        return _changed(preset_options(preset), dict(values))
    except OSError as error:
        raise storage_config_error(path, error.strerror or str(error)) from error
    except (ZbotError, TypeError, ValueError) as error:
        raise storage_config_error(path, str(error)) from error


def _changed(options: McapOptions, values: dict[str, Any]) -> McapOptions:
    changes: dict[str, Any] = {}
    for key, value in values.items():
        if key in _WITHOUT_EFFECT:
            continue
        if key == "compression":
            changes[key] = _compression(value)
        elif key == "chunkSize":
            changes["chunk_bytes"] = _chunk_bytes(value)
        elif key in _NEGATIVE or key in {"noSummary", "enableDataCRC"}:
            changes |= _switch(key, value)
        else:
            raise ValueError(f"zbot does not know the key {key!r}")
    return replace(options, **changes)


def _switch(key: str, value: Any) -> dict[str, bool]:
    if not isinstance(value, bool):
        raise ValueError(f"{key} must be true or false")  # noqa: TRY004 - a wrong value in a file
    if key == "enableDataCRC":
        return {"has_data_crc": value}
    if key == "noSummary":
        fields = ("has_statistics", "has_summary_offsets", "repeats_channels", "repeats_schemas")
        return dict.fromkeys(fields, not value)
    return {_NEGATIVE[key]: not value}


def _compression(value: Any) -> str:
    name = str(value).lower()
    if name not in COMPRESSIONS:
        raise ValueError(f"compression cannot be {value!r}: choose Zstd, Lz4 or None")
    return name


def _chunk_bytes(value: Any) -> int:
    number = int(value)
    if not _MIN_CHUNK_BYTES <= number <= _MAX_CHUNK_BYTES:
        raise ValueError(
            f"chunkSize cannot be {number}: choose {_MIN_CHUNK_BYTES} to {_MAX_CHUNK_BYTES} bytes"
        )
    return number
