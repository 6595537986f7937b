"""Reader of bags: folders, single MCAP files and single sqlite3 files."""

from __future__ import annotations

import heapq
import re
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from zbot.bag import mcap_reader, ros1_reader, sqlite_reader
from zbot.bag.definition import message_class
from zbot.bag.errors import BagNotFoundError, BagReadError, BagTypeError
from zbot.bag.message import NO_DEFINITION, BagMessage, Definition, StorageReader, plain_message
from zbot.bag.metadata import METADATA_FILE, BagMetadata, merged, read_metadata_file
from zbot.wire.serialization import deserialize_message

if TYPE_CHECKING:
    from collections.abc import Collection, Iterable, Iterator
    from types import TracebackType

    from typing_extensions import Self

    from zbot.bag.metadata import TopicMetadata

_STORAGES: dict[str, type[Any]] = {
    ".mcap": mcap_reader.McapReader,
    ".db3": sqlite_reader.SqliteReader,
    ".bag": ros1_reader.Ros1Reader,
}
_PACKED = ".zstd"
# A compressed file may become this large, and larger by this number of times its own size.
_MOST_UNPACKED_BYTES, _MOST_TIMES = 2**28, 200
CDR = "cdr"  #: the only serialization that zbot decodes


class Reader:
    """Reader of a bag.

    Args:
        path: Folder of a bag, or one of its files (`.mcap` or `.db3`), or a bag of ROS 1 (`.bag`).
        storage_id: `mcap` or `sqlite3`. Empty means any.
        uses_metadata_file: Whether to read the description in the folder's `metadata.yaml`. If this
            is false or there is no `metadata.yaml`, the description comes from the other files.

    Raises:
        BagNotFoundError: There is nothing with this path.
        BagReadError: The path is not a bag, or the bag cannot be read.
        NoBagExtraError: The extra `bag` is not installed.
    """

    def __init__(
        self, path: str | Path, storage_id: str = "", *, uses_metadata_file: bool = True
    ) -> None:
        self.path = Path(path)
        self._unpacked: tempfile.TemporaryDirectory[str] | None = None
        self._classes: dict[str, type[Any]] = {}
        if not self.path.exists():
            raise BagNotFoundError(path)
        written = None
        if uses_metadata_file and (self.path / METADATA_FILE).exists():
            written = read_metadata_file(self.path)
        self._paths = self._find(written)
        try:
            self._files = [self._open(part) for part in self._paths]
        except BaseException:
            self.close()
            raise
        self.has_metadata_file = written is not None
        self.metadata: BagMetadata = self._described(written)
        if storage_id and storage_id != self.metadata.storage_id:
            self.close()
            reason = f"its storage is {self.metadata.storage_id}, not {storage_id}"
            raise BagReadError(path, reason)

    @property
    def topics(self) -> dict[str, TopicMetadata]:
        """The topics by name."""
        return {information.topic.name: information.topic for information in self.metadata.topics}

    @property
    def damage(self) -> str:
        """Why only a part of the bag can be read, or an empty text if the bag is complete."""
        return next((part.damage for part in self._files if part.damage), "")

    def definition(self, type_name: str) -> Definition:
        """Return the bag's definition of a message type."""
        found = (part.definitions.get(type_name) for part in self._files)
        return next(filter(None, found), NO_DEFINITION)

    def message_class(self, topic: TopicMetadata) -> type[Any]:
        """Return the class of a topic's messages. The bag's definition is used for unknown types.

        Raises:
            BagTypeError: The type is not known, or is different here, or messages are not in CDR.
        """
        if topic.serialization_format != CDR:
            reason = f"the messages are in the format '{topic.serialization_format}', not in CDR"
            raise BagTypeError(topic.type_name, reason)
        name = topic.type_name
        if name not in self._classes:  # many topics may have the same type, with a long definition
            self._classes[name] = message_class(name, *self.definition(name))
        return self._classes[name]

    def messages(
        self,
        topics: Collection[str] | None = None,
        start_ns: int = 0,
        end_ns: int | None = None,
    ) -> Iterator[BagMessage]:
        """Yield messages in the order in which they were recorded, without decoding them.

        Args:
            topics: Names of topics. `None` means all.
            start_ns: First time, in nanoseconds since the epoch.
            end_ns: Last time. `None` means no limit.

        Raises:
            BagReadError: A part of a file is damaged.
        """
        # Files of a bag follow each other in time, so only one file at a time is open.
        for file in self._files:
            described = file.metadata
            is_early = described.start_ns + described.duration_ns < start_ns
            is_late = end_ns is not None and described.start_ns > end_ns
            if not (is_early or is_late):
                for message in file.messages(topics, start_ns, end_ns):
                    plain = plain_message(message.data)
                    yield message if plain is message.data else message._replace(data=plain)

    def close(self) -> None:
        """Remove temporary files, which exist only for bags with compressed files."""
        if self._unpacked is not None:
            self._unpacked.cleanup()
            self._unpacked = None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def _find(self, written: BagMetadata | None) -> list[Path]:
        if not self.path.is_dir():
            return [self.path]
        if written is not None:
            # Before Foxy, the paths began with the name of the folder.
            # A file that is named several times is read once.
            named = (self._inside(Path(path)) for path in dict.fromkeys(written.paths))
            paths = list(dict.fromkeys(named))
        else:
            paths = bag_files(self.path)
        missing = next((path for path in paths if not path.exists()), None)
        if missing is not None:
            raise BagReadError(self.path, f"its file {missing.name} is missing")
        if not paths:
            raise BagReadError(self.path, "there is no .mcap, .db3 or .bag file in this folder")
        return paths

    def _inside(self, path: Path) -> Path:
        """Return the path of a file that the description names. It is always in the folder."""
        is_inside = not path.is_absolute() and ".." not in path.parts
        whole = self.path / path
        return whole if is_inside and whole.exists() else self.path / path.name

    def _open(self, path: Path) -> StorageReader:
        if not path.is_file():
            raise BagReadError(path, "it is no file")  # a pipe would never end
        packed = path.suffix == _PACKED
        suffix = Path(path.stem).suffix if packed else path.suffix
        storage = _STORAGES.get(suffix)
        if storage is None:
            raise BagReadError(path, "it is no folder, .mcap, .db3 or .bag file")
        opened: StorageReader = storage(self._unpacked_file(path) if packed else path)
        return opened

    def _unpacked_file(self, path: Path) -> Path:
        from zbot.bag.packages import import_mcap  # noqa: PLC0415 - rarely used

        import_mcap()
        import zstandard  # noqa: PLC0415 - an extra

        if self._unpacked is None:
            self._unpacked = tempfile.TemporaryDirectory(prefix="zbot_bag_")
        target = Path(self._unpacked.name) / path.stem
        try:
            limit = _MOST_UNPACKED_BYTES + _MOST_TIMES * path.stat().st_size
            with path.open("rb") as source, target.open("wb") as sink:
                for block in zstandard.ZstdDecompressor().read_to_iter(source):
                    sink.write(block)
                    if sink.tell() > limit:
                        raise BagReadError(path, f"it becomes larger than {limit} bytes")
        except OSError as error:
            raise BagReadError(path, error.strerror or str(error)) from error
        except zstandard.ZstdError as error:
            raise BagReadError(path, f"the file is damaged ({error})") from error
        return target

    def _described(self, written: BagMetadata | None) -> BagMetadata:
        if written is None:
            parts = (
                _renamed(file.metadata, path)
                for file, path in zip(self._files, self._paths, strict=True)
            )
            return merged(parts)
        size = sum(path.stat().st_size for path in self.path.iterdir() if path.is_file())
        return replace(written, bag_size=size)


def bag_files(folder: Path) -> list[Path]:
    """Return the files of a bag in a folder, in the order of their numbers."""
    found = (
        path
        for path in folder.iterdir()
        if path.suffix in _STORAGES
        or (path.suffix == _PACKED and Path(path.stem).suffix in _STORAGES)
    )
    return sorted(found, key=_number)


def read(path: str | Path, topics: Iterable[str] | None = None) -> Iterator[tuple[str, Any, int]]:
    """Yield a bag's messages, decoded, in the order in which they were recorded.

        for topic, msg, t in zbot.bag.read("lesson"):
            print(topic, msg.data, t)

    The definitions of types that this machine does not know come from the bag.

    Args:
        path: Folder of a bag, or one of its files.
        topics: Names of topics. `None` means all.

    Yields:
        The topic, the message, and the time of recording in nanoseconds since the epoch.

    Raises:
        BagNotFoundError: There is nothing with this path.
        BagReadError: The path is not a bag, or a part of the bag is damaged.
        BagTypeError: A type is not known, or is different here, or messages are not in CDR.
        CodecError: The bytes of a message do not fit its type.
        NoBagExtraError: The extra `bag` is not installed.
    """
    # Names in bags begin with a slash, except in some bags that other programs wrote.
    wanted = None if topics is None else {name for topic in topics for name in (topic, f"/{topic}")}
    with Reader(path) as bag:
        known = bag.topics
        classes: dict[str, type[Any]] = {}
        for message in bag.messages(wanted):
            cls = classes.get(message.topic)
            if cls is None:
                cls = classes[message.topic] = bag.message_class(known[message.topic])
            yield message.topic, deserialize_message(message.data, cls), message.log_ns


def merge(streams: Iterable[Iterator[BagMessage]]) -> Iterator[BagMessage]:
    """Yield the messages of several bags, ordered by the time at which they were recorded."""
    return heapq.merge(*streams, key=lambda message: message.log_ns)


def _renamed(part: BagMetadata, path: Path) -> BagMetadata:
    """Return a file's description. A compressed file gets the name that the file has in the bag."""
    if path.suffix != _PACKED:
        return part
    return replace(
        part,
        files=(replace(part.files[0], path=path.name),),
        paths=(path.name,),
        bag_size=path.stat().st_size,
        compression_format="zstd",
        compression_mode="FILE",
    )


def _number(path: Path) -> tuple[int, str]:
    digits = re.search(r"_([0-9]{1,9})\.", path.name)
    return (int(digits.group(1)) if digits else 0, path.name)
