"""Error reply of a service: the kind of error and a message, in place of a response."""

from __future__ import annotations

from typing import Any

from zbot.wire.messagepack import Bytes, UnreadableError, pack, unpack

__all__ = ["ENCODING", "pack_error", "unpack_error"]

ENCODING = "application/msgpack"


def pack_error(error: BaseException) -> bytes:
    """Return the payload for an exception: its class name and its text, which is never empty."""
    kind = type(error).__name__
    return pack({"error": kind, "message": str(error) or kind})


def unpack_error(data: Bytes) -> tuple[str, str]:
    """Return the kind and message of an error reply. Bytes in another format become the message."""
    try:
        reply: Any = unpack(data)
    except UnreadableError:
        reply = None
    if isinstance(reply, dict) and isinstance(reply.get("message"), str):
        return str(reply.get("error", "error")), reply["message"]
    return "error", bytes(data).decode(errors="replace")
