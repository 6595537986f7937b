"""Queries to all sessions of a domain. The queue of each query is large enough for all replies.

Zenoh blocks a whole session while the queue of a query is full. Before `get` returns, the session
puts the replies that it already knows into the queue, but no thread reads the queue yet. Zenoh's
default queue for 256 replies would therefore block a session for ever in a domain with 30 nodes.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, NamedTuple

import zenoh

from zbot.json_reader import JsonError, read_json_object

if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import TypeGuard

# A class of thirty students has 2,000 liveliness tokens. A queue takes memory only for the replies
# in it.
_QUEUE_LENGTH = 1_000_000
_ZID = re.compile("[0-9a-f]{1,32}")
_MAX_TIME_NS = 1 << 63


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
    started_ns: int  #: nanoseconds since the epoch; 0 if the router is not zbot's
    is_replacement: bool  #: whether it replaces a router that was killed


def routers(session: zenoh.Session, router: str, timeout_s: float) -> Iterator[RouterFacts]:
    """Ask a router, or all routers (`*`), for facts about themselves.

    Never query a router's `subscriber`, `publisher`, `queryable` or `token`. During such a query,
    Zenoh 1.10 holds a lock, and locks the same lock again for the reply. If a session declares
    something in between, Zenoh blocks for ever (pull request 2619 of eclipse-zenoh/zenoh).
    """
    for _, text in answers(session, f"@/{router}/router", timeout_s):
        try:
            yield router_facts(text)
        except JsonError:
            continue  # any program can answer, so one wrong answer must not hide the others


def router_facts(text: bytes) -> RouterFacts:
    """Return the facts in a router's answer. Parts that have an unexpected form are left out.

    Raises:
        JsonError: The answer is not a JSON object.
    """
    facts = read_json_object(text)
    linked: dict[str, str] = {}
    for one in _list(facts.get("sessions")):
        zid, kind = _map(one).get("peer"), _map(one).get("whatami")
        # The id becomes a part of keys.
        if isinstance(zid, str) and _ZID.fullmatch(zid) and kind in ("peer", "client"):
            linked[zid] = kind
    zbot = zbot_facts(facts)
    started_ns = zbot.get("started")
    started_ns = started_ns if is_time_ns(started_ns) else 0
    return RouterFacts(linked, started_ns, zbot.get("replaces") is True)


def zbot_facts(facts: dict[str, Any]) -> dict[str, Any]:
    """Return an answer's facts about the zbot process, or `{}` if another program answered."""
    return _map(_map(facts.get("metadata")).get("zbot"))


def is_time_ns(value: object) -> TypeGuard[int]:
    """Return whether a value is a time in nanoseconds since the epoch."""
    return isinstance(value, int) and 0 <= value < _MAX_TIME_NS


def _map(value: object) -> dict[str, Any]:
    return value if isinstance(value, dict) else {}


def _list(value: object) -> list[Any]:
    return value if isinstance(value, list) else []


def sessions(session: zenoh.Session, router: str, timeout_s: float) -> dict[str, str]:
    """Return the sessions that one router or all routers (`*`) list: `peer` or `client` by id."""
    found: dict[str, str] = {}
    for facts in routers(session, router, timeout_s):
        found |= facts.sessions
    return found
