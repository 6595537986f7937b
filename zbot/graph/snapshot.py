"""The graph of a domain: which nodes there are, and what they publish, subscribe to and serve.

It is made of Zenoh liveliness tokens (docs/wire.md), so it is right at once, everywhere, and a
process that dies takes its tokens with it.
"""

from __future__ import annotations

import itertools
import json
import threading
import time
import weakref
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import zenoh

from zbot.errors import InvalidNameError
from zbot.names import SEND_GOAL, fully_qualified, validate_full_topic_name
from zbot.transport import admin_query
from zbot.transport.foreign_call import in_one_go
from zbot.transport.wakeup import BinarySemaphore
from zbot.wire.errors import TokenError
from zbot.wire.tokens import EndpointToken, EntityKind, NodeToken

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

    from zbot.wire.dialect import Dialect

_ANSWER_TIMEOUT_S = 2.0  # 25 ms are usual
#: What the admin space of a Zenoh program calls them.
_FOREIGN_KINDS = {"publisher": EntityKind.PUBLISHER, "subscriber": EntityKind.SUBSCRIPTION}
_MOST_WITHDRAWN = 1000

NamesAndTypes = list[tuple[str, list[str]]]
Token = NodeToken | EndpointToken


@dataclass(frozen=True)
class Snapshot:
    """The graph at one moment."""

    tokens: tuple[Token, ...]

    @cached_property
    def nodes(self) -> list[NodeToken]:
        """One token a node, sorted by full name; equal names appear as often as they exist."""
        found = (token for token in self.tokens if isinstance(token, NodeToken))
        return sorted(found, key=lambda node: (_full(node), node.zid, node.nid))

    @cached_property
    def endpoints(self) -> list[EndpointToken]:
        """All publishers, subscriptions, servers and clients, in a stable order."""
        found = (token for token in self.tokens if isinstance(token, EndpointToken))
        return sorted(found, key=lambda end: (end.name, _full(end), end.zid, end.eid))

    @cached_property
    def _by_name(self) -> dict[str, list[EndpointToken]]:
        found: dict[str, list[EndpointToken]] = {}
        for end in self.endpoints:
            found.setdefault(end.name, []).append(end)
        return found

    def of_kind(self, *kinds: EntityKind) -> Iterator[EndpointToken]:
        """Yield the endpoints of the given kinds."""
        return (end for end in self.endpoints if end.kind in kinds)

    def on(self, name: str, *kinds: EntityKind) -> list[EndpointToken]:
        """Return the endpoints of some kinds on one topic or service."""
        return [end for end in self._by_name.get(name, ()) if end.kind in kinds]

    def publishers(self, topic: str) -> list[EndpointToken]:
        """Return the publishers of a topic."""
        return self.on(topic, EntityKind.PUBLISHER)

    def subscriptions(self, topic: str) -> list[EndpointToken]:
        """Return the subscriptions of a topic."""
        return self.on(topic, EntityKind.SUBSCRIPTION)

    def names_and_types(self, *kinds: EntityKind, node: str | None = None) -> NamesAndTypes:
        """Return each name once with its types, sorted; only those of `node`, if given."""
        found: dict[str, set[str]] = {}
        for end in self.of_kind(*kinds):
            if node is None or _full(end) == node:
                found.setdefault(end.name, set()).add(end.type_name)
        return [(name, sorted(types)) for name, types in sorted(found.items())]

    def topics(self) -> NamesAndTypes:
        """Return every topic with its types."""
        return self.names_and_types(EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION)

    def services(self) -> NamesAndTypes:
        """Return every service that has a server, with its types."""
        return self.names_and_types(EntityKind.SERVICE)

    def actions(
        self,
        *kinds: Literal[EntityKind.SERVICE, EntityKind.CLIENT],
        node: str | None = None,
    ) -> NamesAndTypes:
        """Return each action with its types, sorted; only those with servers or clients, if given.

        An action is known by the service that takes its goals.
        """
        kinds = kinds or (EntityKind.SERVICE, EntityKind.CLIENT)
        return [
            (name.removesuffix(SEND_GOAL), [one.removesuffix("_SendGoal") for one in types])
            for name, types in self.names_and_types(*kinds, node=node)
            if name.endswith(SEND_GOAL)
        ]


class Announcement:
    """A node or endpoint that others can see until it is undeclared, or the session closed."""

    def __init__(self, graph: Graph, session: zenoh.Session, token: Token) -> None:
        self._graph = graph
        self._token = token
        self._declared = session.liveliness().declare_token(token.key)
        graph.note(token, appeared=True)

    def undeclare(self) -> None:
        """Withdraw it."""
        self._declared.undeclare()
        self._graph.note(self._token, appeared=False)


class Graph:
    """The live graph of one context.

    Listeners are called in a thread of Zenoh's, or in the one that announces something: they must
    be quick and not block.

    Args:
        session: The session through which tokens are seen.
        dialect: How tokens are written.
        domain: 0 to 232.
        settle: Waits until everybody has answered a question; called at the first look.
        receiver: Makes a function into what Zenoh calls until the session is closed.
        asks_first: Whether to ask who is there before following changes. A client's session answers
            queries by itself, and incompletely, as soon as it follows them.
    """

    def __init__(
        self,
        session: zenoh.Session,
        dialect: Dialect,
        domain: int,
        *,
        asks_first: bool = False,
        settle: Callable[[], None],
        receiver: Callable[[Callable[[zenoh.Sample], None]], Any],
    ) -> None:
        self._session = session
        self._settle = settle
        self._receiver = receiver
        self._dialect = dialect
        self._domain = domain
        self._keys = dialect.tokens_keys(domain)
        self._tokens: dict[str, Token] = {}
        self._by_gid: dict[bytes, EndpointToken] = {}
        # Programs count who listens before every message: what was sorted serves until a change.
        self._snapshot: Snapshot | None = None
        self._lock = threading.RLock()  # re-entrant, for a signal's handler
        self._listeners: list[weakref.ref[Any]] = []
        self._asks_first = asks_first
        self._watching = False
        self._is_complete = False
        self._gone: set[str] = set()
        # Own tokens whose coming and going may still be queued, or was never told.
        self._withdrawn: dict[str, None] = {}
        # No condition variable: a signal's exception could leave it taken, and Zenoh stuck.
        self._waiting: set[BinarySemaphore] = set()

    def watch(self) -> None:
        """Begin to follow changes; `find` knows nothing before."""
        with self._lock:
            if self._watching:
                return
            self._watching = True
        if self._asks_first:
            self._complete()
        for key in self._keys:
            self._declare_subscriber(key, self._receiver(self._on_sample))

    def announce(self, token: Token) -> Announcement:
        """Declare a token of this context, which its own graph shows at once."""
        return Announcement(self, self._session, token)

    def note(self, token: Token, *, appeared: bool) -> None:
        """Change what is known, and tell the listeners if that is news."""
        if appeared:
            changed = self._add(token)
        else:
            with self._lock:
                changed = self._forget(token.key) is not None
                if self._watching:
                    self._withdrawn[token.key] = None
                    if len(self._withdrawn) > _MOST_WITHDRAWN:
                        del self._withdrawn[next(iter(self._withdrawn))]
        if changed:
            self._tell(token, appeared)

    def snapshot(self) -> Snapshot:
        """Return the graph as it is now, complete from the first call on (1 to 25 ms then)."""
        if not self._asks_first:
            # What comes or goes during the first look must not be missed.
            self.watch()
        if not self._watching:
            return Snapshot(tuple(self._ask()))
        if not self._is_complete:
            self._complete()
        with self._lock:
            if self._snapshot is None:
                self._snapshot = Snapshot(tuple(self._tokens.values()))
            return self._snapshot

    def wait_for(self, condition: Callable[[Snapshot], bool], timeout_s: float) -> bool:
        """Wait until a condition on the graph holds; `False` if it did not in `timeout_s`."""
        self.watch()
        changed = BinarySemaphore()
        self._waiting.add(changed)
        deadline = time.monotonic() + timeout_s
        try:
            while not condition(self.snapshot()):
                left = deadline - time.monotonic()
                if left <= 0:
                    return False
                changed.wait(left)
            return True
        finally:
            self._waiting.discard(changed)

    def _complete(self) -> None:
        tokens = list(self._ask())
        for token in tokens:
            self._add(token)
        with self._lock:
            # A token may have gone between its answer and here.
            for key in self._gone & self._tokens.keys():
                self._forget(key)
            self._gone.clear()
            self._is_complete = True

    def _forget(self, key: str) -> Token | None:
        gone = self._tokens.pop(key, None)
        self._snapshot = None
        if isinstance(gone, EndpointToken):
            self._by_gid.pop(gone.gid, None)
        return gone

    def find(self, gid: bytes) -> EndpointToken | None:
        """Return the endpoint that a message's gid names, if it is known (by now)."""
        return self._by_gid.get(gid)

    def add_listener(self, listener: Callable[[Token, bool], None]) -> None:
        """Call a bound method `listener(token, appeared)` at each change while its object lives."""
        self.watch()
        with self._lock:
            self._listeners.append(weakref.WeakMethod(listener))
            tokens = list(self._tokens.values())
        for token in tokens:
            listener(token, True)

    def remove_listener(self, listener: Callable[[Token, bool], None]) -> None:
        """Stop calling a listener."""
        with self._lock:
            self._listeners = [ref for ref in self._listeners if ref() not in {None, listener}]

    def _ask(self) -> Iterator[Token]:
        for key in self._asked_of_router() if self._asks_first else self._told_by_peers():
            token = self._parse(key)
            if token is not None:
                yield token

    def _asked_of_router(self) -> Iterable[str]:
        asked = [admin_query.tokens(self._session, key, _ANSWER_TIMEOUT_S) for key in self._keys]
        return itertools.chain.from_iterable(asked)

    def _told_by_peers(self) -> Iterable[str]:
        # A peer that follows tokens answers its own questions from what it happens to have heard.
        # Whoever is told that tokens are followed sends theirs, and then answers what comes next.
        subscribers = [self._declare_subscriber(key, admin_query.room()) for key in self._keys]
        self._settle()
        keys: dict[str, None] = {}
        for subscriber in subscribers:
            while (sample := subscriber.handler.try_recv()) is not None:
                if sample.kind == zenoh.SampleKind.PUT:
                    keys[str(sample.key_expr)] = None
                else:
                    keys.pop(str(sample.key_expr), None)
            subscriber.undeclare()
        return keys

    def _declare_subscriber(self, key: str, handler: Any) -> Any:
        subscribe = self._session.liveliness().declare_subscriber
        return in_one_go(subscribe, key, handler, history=True)

    def _parse(self, key: str) -> Token | None:
        try:
            return self._dialect.parse_token(key)
        except TokenError:
            return None  # anybody may declare tokens; what is no ROS token is not in the graph

    def _on_sample(self, sample: zenoh.Sample) -> None:
        key = str(sample.key_expr)
        if sample.kind == zenoh.SampleKind.PUT:
            token = self._parse(key)
            if token is not None and self._add(token):
                self._tell(token, True)
            return
        with self._lock:
            gone = self._forget(key)
            self._withdrawn.pop(key, None)
            if not self._is_complete:
                self._gone.add(key)
        if gone is not None:
            self._tell(gone, False)

    def _add(self, token: Token) -> bool:
        with self._lock:
            if token.key in self._tokens or token.key in self._withdrawn:
                return False
            self._tokens[token.key] = token
            self._snapshot = None
            if isinstance(token, EndpointToken):
                self._by_gid[token.gid] = token
            return True

    def _tell(self, token: Token, appeared: bool) -> None:
        for changed in list(self._waiting):
            changed.set()
        for ref in list(self._listeners):
            listener = ref()
            if listener is not None:
                listener(token, appeared)


class Process(NamedTuple):
    """What a session tells of its process in the admin space."""

    zid: str
    host: str
    pid: int
    started_ns: int  #: nanoseconds since the epoch
    version: str  #: of zbot
    command: str


def processes(session: zenoh.Session) -> dict[str, Process]:
    """Return the zbot processes that can be seen, by session id (1 to 25 ms)."""
    found = {}
    for key, facts in admin_query.answers(session, "@/*/*", _ANSWER_TIMEOUT_S):
        zid = key.split("/")[1]
        process = _process(zid, facts)
        if process is not None:
            found[zid] = process
    return found


def _process(zid: str, payload: bytes) -> Process | None:
    try:
        facts = json.loads(payload)["metadata"]["zbot"]
        return Process(
            zid,
            str(facts["host"]),
            int(facts["pid"]),
            int(facts["started"]),
            str(facts["version"]),
            str(facts["command"]),
        )
    except (ValueError, KeyError, TypeError):
        return None  # a Zenoh program that is not zbot's


def foreign_topics(
    session: zenoh.Session, snapshot: Snapshot, domain: int
) -> dict[str, set[EntityKind]]:
    """Return the topics that only plain Zenoh programs use, as these tell themselves.

    Args:
        session: A client's session.
        snapshot: The graph: what it knows is not foreign.
        domain: 0 to 232.
    """
    own = {token.zid for token in snapshot.tokens} | {str(session.info.zid())}
    strangers = admin_query.sessions(session, "*", _ANSWER_TIMEOUT_S).keys() - own
    # All are asked before the first answer is waited for.
    asked = [
        admin_query.answers(session, f"@/{zid}/*/*/{domain}/**", _ANSWER_TIMEOUT_S)
        for zid in strangers
    ]
    known = {end.name for end in snapshot.endpoints}
    found: dict[str, set[EntityKind]] = {}
    for key, _ in itertools.chain.from_iterable(asked):
        *_, word, _, name = key.split("/", 5)
        kind = _FOREIGN_KINDS.get(word)
        if kind is not None and f"/{name}" not in known and _is_name(f"/{name}"):
            found.setdefault(f"/{name}", set()).add(kind)
    return found


def _is_name(name: str) -> bool:
    try:
        return validate_full_topic_name(name)
    except InvalidNameError:
        return False  # a wildcard, or a key that is no ROS name


def _full(token: Token) -> str:
    return fully_qualified(token.namespace, token.node)


def full_names(tokens: Iterable[Token]) -> list[str]:
    """Return the full names of the nodes that tokens belong to."""
    return [_full(token) for token in tokens]
