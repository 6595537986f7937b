"""Format of a payload: CDR or MessagePack."""

from __future__ import annotations

__all__ = ["is_cdr"]


def is_cdr(data: bytes) -> bool:
    """Return whether bytes begin with a CDR header. A MessagePack map never has one."""
    return data[:1] == b"\x00" and data[1:2] in {b"\x00", b"\x01"}
