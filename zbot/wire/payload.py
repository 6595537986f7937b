"""Which format a message's bytes have."""

from __future__ import annotations

__all__ = ["is_cdr"]


def is_cdr(data: bytes) -> bool:
    """Tell whether bytes begin as CDR does: MessagePack's maps never do."""
    return data[:1] == b"\x00" and data[1:2] in {b"\x00", b"\x01"}
