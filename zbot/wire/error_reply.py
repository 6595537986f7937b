"""Error reply of a service: the kind of error and a message, in place of a response."""

from __future__ import annotations

from typing import Any

from zbot.wire.messagepack.packing import Bytes, UnreadableError, pack, unpack

__all__ = ["ENCODING", "error_text", "pack_error", "unpack_error"]

ENCODING = "application/msgpack"


def pack_error(error: BaseException) -> bytes:
    """Return the payload for an exception: its class name and its text, which is never empty."""
    kind = type(error).__name__
    return pack({"error": kind, "message": str(error) or kind})


def error_text(error: BaseException) -> str:
    """Return an exception as one text: its class name, a colon and its own text."""
    kind = type(error).__name__
    return f"{kind}: {error}" if str(error) else kind


def unpack_error(data: Bytes) -> tuple[str, str]:
    """Return the kind and message of an error reply. Bytes in another format become the message."""
    try:
        reply: Any = unpack(data)
    except UnreadableError:
        reply = None
    if isinstance(reply, dict) and isinstance(reply.get("message"), str):
        return str(reply.get("error", "error")), reply["message"]
    text = bytes(data).decode(errors="replace")
    kind, colon, message = text.partition(": ")
    return (kind, message) if colon and kind.isidentifier() else ("error", text)
