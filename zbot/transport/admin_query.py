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


def sessions(session: zenoh.Session, router: str, timeout_s: float) -> dict[str, str]:
    """Ask a router, or all (`*`), whom it is linked to; return `peer` or `client` by session id.

    Never ask a router for its `subscriber`, `publisher`, `queryable` or `token`: Zenoh 1.10 holds a
    lock while it answers that, takes it again for the answer, and stops for good if somebody
    declares something in between (pull request 2619 of eclipse-zenoh/zenoh).
    """
    found: dict[str, str] = {}
    for _, facts in answers(session, f"@/{router}/router", timeout_s):
        found |= _sessions_in(facts)
    return found


def _sessions_in(router_facts: bytes) -> dict[str, str]:
    """Return peers and clients by session id, from a router's admin space root (JSON)."""
    import json  # noqa: PLC0415 - later than everything that somebody waits for

    sessions = json.loads(router_facts).get("sessions", [])
    return {
        entry["peer"]: entry["whatami"]
        for entry in sessions
        if entry.get("whatami") in {"peer", "client"}
    }
