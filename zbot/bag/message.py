"""Message of a bag, and the methods of the readers and writers of all formats."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, Protocol

from zbot.bag.errors import BagReadError

if TYPE_CHECKING:
    from collections.abc import Collection, Iterator
    from pathlib import Path

    from zbot.bag.metadata import BagMetadata, TopicMetadata


class BagMessage(NamedTuple):
    """Message of a bag, not decoded. Times are nanoseconds since the epoch."""

    topic: str
    data: bytes  #: the message in CDR
    log_ns: int  #: time of recording
    publish_ns: int  #: time of sending, or the time of recording if the bag has no time of sending


class Definition(NamedTuple):
    """Definition of a message type in a bag."""

    encoding: str  #: `ros2msg` or `ros2idl`, or empty if the bag has no definition
    text: str


NO_DEFINITION = Definition("", "")


class StorageReader(Protocol):
    """Reader of one file of a bag."""

    metadata: BagMetadata
    definitions: dict[str, Definition]  #: by the name of the type
    damage: str  #: why only a part of the file can be read, or empty if the file is complete

    def messages(
        self, topics: Collection[str] | None, start_ns: int, end_ns: int | None
    ) -> Iterator[BagMessage]:
        """Yield the messages of some topics, ordered by the time at which they were recorded.

        Args:
            topics: Names of topics. `None` means all.
            start_ns: First time of recording.
            end_ns: Last time of recording. `None` means no limit.
        """
        ...


class StorageWriter(Protocol):
    """Writer of one file of a bag. After an `OSError`, only `abandon` may be called."""

    path: Path

    @property
    def size(self) -> int:
        """Bytes of the file so far."""
        ...

    @property
    def message_count(self) -> int:
        """Messages in the file."""
        ...

    @property
    def start_ns(self) -> int:
        """Time of the first message."""
        ...

    def add_topic(self, topic: TopicMetadata, definition: Definition) -> None:
        """Add a topic. All messages of the topic come later."""
        ...

    def write(self, topic: str, data: bytes, log_ns: int, publish_ns: int) -> None:
        """Add a message. The message is in the file after the next `flush`, or earlier."""
        ...

    def flush(self) -> None:
        """Write all messages so far into the file."""
        ...

    def close(self, custom_data: dict[str, str], ros_distro: str) -> BagMetadata:
        """Write the end of the file, and return the description of the file."""
        ...

    def abandon(self) -> None:
        """Close the file after an error."""
        ...


# First bytes of a compressed message. A message in CDR begins with a zero byte. So the reader sees
# without the bag's metadata whether a message is compressed.
_ZSTD_MAGIC = b"\x28\xb5\x2f\xfd"
_MOST_BYTES = 2**30


def compressed_message(data: bytes) -> bytes:
    """Return a message in zstd."""
    import zstandard  # noqa: PLC0415 - an extra

    packed: bytes = zstandard.ZstdCompressor().compress(data)
    return packed


def plain_message(data: bytes) -> bytes:
    """Return a message in CDR. A message that is not compressed is returned as it is.

    Raises:
        BagReadError: The message is damaged or larger than 1 GiB.
    """
    if not data.startswith(_ZSTD_MAGIC):
        return data
    import zstandard  # noqa: PLC0415 - an extra

    try:
        if zstandard.frame_content_size(data) > _MOST_BYTES:
            raise BagReadError("message", f"a compressed message has more than {_MOST_BYTES} bytes")
        plain: bytes = zstandard.ZstdDecompressor().decompress(data, max_output_size=_MOST_BYTES)
    except zstandard.ZstdError as error:
        raise BagReadError("message", f"a compressed message is damaged ({error})") from error
    return plain
