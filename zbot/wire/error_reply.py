"""What a server says instead of a response: the kind of error, and one sentence."""

from __future__ import annotations

from typing import Any

from zbot.wire.messagepack import Bytes, UnreadableError, pack, unpack

__all__ = ["ENCODING", "pack_error", "unpack_error"]

ENCODING = "application/msgpack"


def pack_error(error: BaseException) -> bytes:
    """Return the payload for an exception: its class and its text, or twice the class."""
    kind = type(error).__name__
    return pack({"error": kind, "message": str(error) or kind})


def unpack_error(data: Bytes) -> tuple[str, str]:
    """Return kind and sentence; of bytes that another program wrote, whatever text they are."""
    try:
        told: Any = unpack(data)
    except UnreadableError:
        told = None
    if isinstance(told, dict) and isinstance(told.get("message"), str):
        return str(told.get("error", "error")), told["message"]
    return "error", bytes(data).decode(errors="replace")
