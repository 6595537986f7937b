from __future__ import annotations

import pytest

from zbot.wire.attachment import Attachment, pack, unpack

GID = bytes(range(16))
# Example in rmw_zenoh's layout: number 1, 1700000000.123456789 s, gid 00..0f.
GOLDEN = bytes.fromhex("010000000000000015cd853dfe9c971710000102030405060708090a0b0c0d0e0f")


def test_the_layout_is_that_of_rmw_zenoh() -> None:
    assert pack(1, 1_700_000_000_123_456_789, GID) == GOLDEN


@pytest.mark.parametrize("kind", [bytes, bytearray, memoryview])
def test_an_attachment_round_trips(kind: type[bytes]) -> None:
    assert unpack(kind(GOLDEN)) == Attachment(1, 1_700_000_000_123_456_789, GID)


@pytest.mark.parametrize(
    "data",
    [
        None,
        b"",
        GOLDEN[:-1],
        GOLDEN + b"\0",
        GOLDEN[:16] + b"\x0f" + GOLDEN[17:],
        b"\xff" * 8 + GOLDEN[8:],
        GOLDEN[:8] + b"\xff" * 8 + GOLDEN[16:],
    ],
)
def test_an_absent_or_foreign_attachment_unpacks_to_none(data: bytes | None) -> None:
    assert unpack(data) is None
