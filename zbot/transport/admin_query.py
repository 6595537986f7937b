"""Queries to all sessions of a domain. The queue of each query is large enough for all replies.

Zenoh blocks a whole session while the queue of a query is full. Before `get` returns, the session
puts the replies that it already knows into the queue, but no thread reads the queue yet. Zenoh's
default queue for 256 replies would therefore block a session for ever in a domain with 30 nodes.
"""

from __future__ import annotations

import re
import socket
from typing import TYPE_CHECKING, Any, NamedTuple

import zenoh

from zbot.text.json_reader import JsonError, read_json_object
from zbot.text.terminal import single_line
from zbot.transport.process_facts import process_space

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator
    from typing import TypeGuard

# A class of thirty students has 2,000 liveliness tokens. A queue takes memory only for the replies
# in it.
_QUEUE_LENGTH = 1_000_000
_ZID = re.compile("[0-9a-f]{1,32}")
_MAX_TIME_NS = 1 << 63
_ANSWER_TIMEOUT_S = 2.0  # usually, the answers take at most 25 ms
_BUSY_TIMEOUT_S = 10.0
_MAX_PID = 1 << 31
_MAX_FACT = 1000  # characters


def large_queue() -> Any:
    """Return a queue for Zenoh that never gets full."""
    return zenoh.handlers.FifoChannel(_QUEUE_LENGTH)


def tokens(session: zenoh.Session, key: str, timeout_s: float) -> Iterator[str]:
    """Query the liveliness tokens that match a key expression, and yield their keys."""
    replies = session.liveliness().get(key, large_queue(), timeout=timeout_s)
    return (str(reply.ok.key_expr) for reply in replies if reply.ok is not None)


def all_tokens(session: zenoh.Session, keys: Iterable[str]) -> list[str]:
    """Query the liveliness tokens that match key expressions, and return their keys.

    A router that is busy for longer than usual is asked once more. If it does not answer then, a
    warning says that the result lacks something.
    """
    for timeout_s in (_ANSWER_TIMEOUT_S, _BUSY_TIMEOUT_S):
        asked = [session.liveliness().get(key, large_queue(), timeout=timeout_s) for key in keys]
        replies = [reply for replies in asked for reply in replies]
        found = [str(reply.ok.key_expr) for reply in replies if reply.ok is not None]
        if len(found) == len(replies):
            return found
    from zbot.log import get_logger  # noqa: PLC0415 - seldom used

    get_logger("zbot").warning(
        f"the router did not answer within {_BUSY_TIMEOUT_S:g} s: some nodes may be missing"
    )
    return found


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
    for session in _list(facts.get("sessions")):
        zid, kind = _map(session).get("peer"), _map(session).get("whatami")
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


class Process(NamedTuple):
    """Process of a session. The session describes it in Zenoh's admin space."""

    zid: str
    host: str
    pid: int
    started_ns: int  #: nanoseconds since the epoch
    version: str  #: the version of zbot
    command: str
    space: str = ""  #: see `process_space`; empty if the process does not say it

    @property
    def is_here(self) -> bool:
        """Whether the pid means the same process for this process."""
        is_same_host = self.host == socket.gethostname()
        return is_same_host and self.space in {"", process_space()}


def processes(session: zenoh.Session) -> dict[str, Process]:
    """Return the zbot processes of reachable sessions, by session id. This takes 1 to 25 ms."""
    found = {}
    for key, facts in answers(session, "@/*/*", _ANSWER_TIMEOUT_S):
        zid = key.split("/")[1]
        process = process_of(zid, facts)
        if process is not None:
            found[zid] = process
    return found


def process_of(zid: str, payload: bytes) -> Process | None:
    """Return the process that an answer describes, or None for a program without zbot.

    The texts have one line without control characters, and are shortened.
    """
    try:
        facts = zbot_facts(read_json_object(payload))
    except JsonError:
        return None  # any program can answer
    pid, started_ns = facts.get("pid"), facts.get("started")
    # `zbot node kill` kills the process with this pid. For the system call, the pids 0 and -1 would
    # mean many processes.
    if not isinstance(pid, int) or not 0 < pid < _MAX_PID or not is_time_ns(started_ns):
        return None  # a Zenoh program that does not use zbot
    texts = (single_line(str(facts.get(key)), _MAX_FACT) for key in ("host", "version", "command"))
    host, version, command = texts
    space = single_line(str(facts.get("space", "")), _MAX_FACT)
    return Process(zid, host, int(pid), started_ns, version, command, space)
