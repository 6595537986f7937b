"""Compression of single messages, which rosbag2 calls the mode MESSAGE."""

from __future__ import annotations

from zbot.bag.errors import BagReadError

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
