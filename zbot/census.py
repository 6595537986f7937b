"""Questions to everybody, and room for all their answers.

Zenoh stops a session, and all that uses it, while the queue of one query or of tokens is full. What
it knows itself it answers before it returns from asking, when nobody reads yet: its own queues, of
256 places, would stop a session for good where 30 nodes are.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import zenoh

if TYPE_CHECKING:
    from collections.abc import Iterator

# A class of thirty has 2,000 tokens. Places are not paid for before they are taken.
_ROOM = 1_000_000


def room() -> Any:
    """Return a queue for Zenoh that nobody fills up."""
    return zenoh.handlers.FifoChannel(_ROOM)


def tokens(session: zenoh.Session, key: str, timeout_s: float) -> Iterator[str]:
    """Ask at once for the liveliness tokens that match a key expression; yield their keys."""
    replies = session.liveliness().get(key, room(), timeout=timeout_s)
    return (str(reply.ok.key_expr) for reply in replies if reply.ok is not None)


def answers(session: zenoh.Session, key: str, timeout_s: float) -> Iterator[tuple[str, bytes]]:
    """Ask at once for the values that match a key expression; yield their keys and payloads."""
    replies = session.get(key, room(), timeout=timeout_s)
    return (
        (str(reply.ok.key_expr), reply.ok.payload.to_bytes())
        for reply in replies
        if reply.ok is not None
    )
