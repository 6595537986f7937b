"""Queries to all sessions of a domain. The queue of each query is large enough for all replies.

Zenoh stops a whole session while the queue of a query is full. Before `get` returns, the session
puts the replies that it already knows into the queue, but no thread reads the queue yet. Zenoh's
default queue for 256 replies would therefore stop a session for ever in a domain with 30 nodes.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import zenoh

if TYPE_CHECKING:
    from collections.abc import Iterator

# A class of thirty students has 2,000 tokens. A queue takes memory only for the replies in it.
_QUEUE_LENGTH = 1_000_000


def large_queue() -> Any:
    """Return a queue for Zenoh that never gets full."""
    return zenoh.handlers.FifoChannel(_QUEUE_LENGTH)


def tokens(session: zenoh.Session, key: str, timeout_s: float) -> Iterator[str]:
    """Query the liveliness tokens that match a key expression, and yield their keys."""
    replies = session.liveliness().get(key, large_queue(), timeout=timeout_s)
    return (str(reply.ok.key_expr) for reply in replies if reply.ok is not None)


def answers(session: zenoh.Session, key: str, timeout_s: float) -> Iterator[tuple[str, bytes]]:
    """Query the values that match a key expression, and yield their keys and payloads."""
    replies = session.get(key, large_queue(), timeout=timeout_s)
    return (
        (str(reply.ok.key_expr), reply.ok.payload.to_bytes())
        for reply in replies
        if reply.ok is not None
    )


class RouterFacts(NamedTuple):
    """Facts that a router gives about itself."""

    sessions: dict[str, str]  #: `peer` or `client` for the id of each linked session
    started_ns: int  #: start of its process, nanoseconds since the epoch; 0 if it is not zbot's


def routers(session: zenoh.Session, router: str, timeout_s: float) -> Iterator[RouterFacts]:
    """Ask a router, or all routers (`*`), for facts about themselves.

    Never query a router's `subscriber`, `publisher`, `queryable` or `token`. During such a query,
    Zenoh 1.10 holds a lock, and takes it again for the reply. If a session declares something in
    between, Zenoh blocks for ever (pull request 2619 of eclipse-zenoh/zenoh).
    """
    import json  # noqa: PLC0415 - not needed before a program's first message

    for _, text in answers(session, f"@/{router}/router", timeout_s):
        facts = json.loads(text)
        found = {one["peer"]: one.get("whatami") for one in facts.get("sessions", [])}
        linked = {zid: kind for zid, kind in found.items() if kind in {"peer", "client"}}
        zbot = (facts.get("metadata") or {}).get("zbot") or {}
        yield RouterFacts(linked, zbot.get("started", 0))


def sessions(session: zenoh.Session, router: str, timeout_s: float) -> dict[str, str]:
    """Return `peer` or `client` for each session that is linked to a router, or to all (`*`)."""
    found: dict[str, str] = {}
    for facts in routers(session, router, timeout_s):
        found |= facts.sessions
    return found
