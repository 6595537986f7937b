"""Graph of a domain, with nodes, publishers, subscriptions, servers and clients.

The graph consists of Zenoh liveliness tokens (docs/wire.md). All sessions see each change
immediately, and Zenoh removes the tokens of a process that ends for any reason.
"""

from __future__ import annotations

import itertools
import threading
import weakref
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

import zenoh

from zbot.errors import InvalidNameError
from zbot.graph.entity_numbers import EntityNumbers
from zbot.graph.token_changes import TokenChanges, declare_subscriber, unless_closed
from zbot.names import SEND_GOAL, validate_full_topic_name
from zbot.threads.deadline import Deadline
from zbot.threads.foreign_call import without_interruption
from zbot.threads.wakeup import BinarySemaphore
from zbot.transport import admin_query
from zbot.wire.errors import TokenError
from zbot.wire.tokens import EndpointToken, EntityKind, NodeToken

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

    from zbot.wire.dialect import Dialect

_ANSWER_TIMEOUT_S = 2.0  # usually, the answers take at most 25 ms
#: Words in the keys of Zenoh's admin space.
_FOREIGN_KINDS = {"publisher": EntityKind.PUBLISHER, "subscriber": EntityKind.SUBSCRIPTION}
# A context that follows more names than this watches the whole graph, because Zenoh compares each
# new token with each name.
_MOST_FOLLOWED = 50

NamesAndTypes = list[tuple[str, list[str]]]
Token = NodeToken | EndpointToken


@dataclass(frozen=True)
class Snapshot:
    """The graph at one moment."""

    tokens: tuple[Token, ...]

    @cached_property
    def nodes(self) -> list[NodeToken]:
        """One token for each node, sorted by full name. Several nodes can have the same name."""
        found = (token for token in self.tokens if isinstance(token, NodeToken))
        return sorted(found, key=lambda node: (node.full_node_name, node.zid, node.nid))

    @cached_property
    def endpoints(self) -> list[EndpointToken]:
        """All publishers, subscriptions, servers and clients, in a stable order."""
        found = (token for token in self.tokens if isinstance(token, EndpointToken))
        return sorted(found, key=lambda end: (end.name, end.full_node_name, end.zid, end.eid))

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
        """Return sorted names with their types, or with `node` only the names of this node."""
        found: dict[str, set[str]] = {}
        for end in self.of_kind(*kinds):
            if node is None or end.full_node_name == node:
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
        """Return the actions that have endpoints of the given kinds, with their types, sorted.

        If `node` is given, return only this node's actions. The names come from the services
        `_action/send_goal`, because each action has such a service.
        """
        kinds = kinds or (EntityKind.SERVICE, EntityKind.CLIENT)
        return [
            (
                name.removesuffix(SEND_GOAL),
                [type_name.removesuffix("_SendGoal") for type_name in types],
            )
            for name, types in self.names_and_types(*kinds, node=node)
            if name.endswith(SEND_GOAL)
        ]


class Announcement:
    """Token of a node or endpoint. The token exists until `undeclare` or the end of its session."""

    def __init__(
        self, graph: Graph, session: zenoh.Session, token: Token, *, is_visible: bool
    ) -> None:
        self._graph = graph
        self._token = token
        self._declared: Any = None
        self._is_over = False
        self._as_read = graph.as_read(token)
        if is_visible:
            declare = session.liveliness().declare_token
            self._declared = without_interruption(declare, token.key)
            graph.note(self._as_read, appeared=True)

    def undeclare(self) -> None:
        """Remove the token from the graph. An equal entity may have its number from now on."""
        if self._is_over:
            return  # the number may belong to another entity now
        self._is_over = True
        if self._declared is not None:
            without_interruption(self._declared.undeclare)
            self._graph.note(self._as_read, appeared=False)
        self._graph.numbers.release(self._token)


class Graph:
    """Graph of one context. The graph always has the present state of the domain.

    Listeners are methods of objects. They are called in a thread of the graph, or in the thread
    that calls `announce`, `undeclare` or `add_listener`. They must return quickly, and must not
    block.

    Args:
        session: The session that receives the tokens.
        dialect: The format of tokens.
        domain: 0 to 232.
        settle: Function that waits until all sessions have sent their tokens. The first snapshot
            calls it.
        receiver: Returns a Zenoh handler that calls a function (see `Context.receiver`).
        start_thread: Starts a thread with a name, a function, and a function that lets it end (see
            `Context.start_thread`).
        is_running: Returns whether the context runs. If not, `wait_for` ends.
        asks_first: Whether to query all tokens before the subscription to changes. This is
            necessary for a client's session. After the subscription, this session would answer the
            query itself, but incompletely.
    """

    def __init__(
        self,
        session: zenoh.Session,
        dialect: Dialect,
        domain: int,
        *,
        asks_first: bool = False,
        settle: Callable[[], None],
        receiver: Callable[[Callable[[Any], object]], Any],
        start_thread: Callable[[str, Callable[[], None], Callable[[], object]], None],
        is_running: Callable[[], bool],
    ) -> None:
        self._session = session
        self._settle = settle
        self._is_running = is_running
        self._changes = TokenChanges(session, self._on_change, receiver, start_thread)
        self._dialect = dialect
        self._domain = domain
        self._keys = dialect.token_selectors(domain)
        self.numbers = EntityNumbers()  #: the numbers of this context's nodes and endpoints
        self._own = f"/{session.info.zid()}/"  # a part of the keys of this context's tokens
        self._tokens: dict[str, Token] = {}
        self._by_gid: dict[bytes, EndpointToken] = {}
        # Cached until a change, because programs count subscriptions before every message.
        self._snapshot: Snapshot | None = None
        self._lock = threading.RLock()  # re-entrant: a signal handler may use the graph
        self._listeners: list[weakref.ref[Any]] = []
        self._asks_first = asks_first
        self._followed: set[str] = set()  # key expressions
        self._watching = False
        self._is_complete = False
        self._gone: set[str] = set()
        # Semaphores are safe: a signal handler's exception could leave a condition variable locked.
        self._waiting: set[BinarySemaphore] = set()

    def watch(self) -> None:
        """Subscribe to all changes. Before this call, `find` knows only the tokens of `follow`."""
        with self._lock:
            if self._watching:
                return
            self._watching = True
        if self._asks_first:
            self._complete()
        for key in self._keys:
            self._changes.follow(key)

    def follow(self, token: Token) -> None:
        """Subscribe to all tokens with the node name or the topic of `token`.

        `find` and the listeners then know these tokens. This session does not receive the tokens of
        the whole domain, which are some thousands in a domain of 200 nodes.
        """
        self._follow(self._dialect.namesake_selector(token))

    def follow_type(self, domain: int, kind: EntityKind, type_name: str) -> None:
        """Subscribe to the tokens of the endpoints of one kind and type."""
        self._follow(self._dialect.type_selector(domain, kind, type_name))

    def _follow(self, key: str) -> None:
        with self._lock:
            if self._watching or key in self._followed:
                return
            self._followed.add(key)
            is_small = len(self._followed) <= _MOST_FOLLOWED
        if is_small:
            self._changes.follow(key)
        else:
            self.watch()

    def known(self) -> tuple[Token, ...]:
        """Return the tokens that this session has received so far, without a query."""
        with self._lock:
            return tuple(self._tokens.values())

    def query(self) -> Snapshot:
        """Return the graph as it is now, but do not watch its changes. This takes 1 to 25 ms."""
        return self.snapshot() if self._watching else Snapshot(tuple(self._query_tokens()))

    def announce(self, token: Token, *, is_visible: bool = True) -> Announcement:
        """Declare a token of this context. This graph contains the token immediately.

        The graph contains it as other sessions read it, e.g. with the policies that the profile's
        `SYSTEM_DEFAULT` stands for.

        Args:
            token: The token, with a number from `numbers`.
            is_visible: Whether the graph shows the token. If not, only its number is reserved.
        """
        return Announcement(self, self._session, token, is_visible=is_visible)

    def as_read(self, token: Token) -> Token:
        """Return a token of this context as other sessions read it."""
        return self._parse(token.key) or token

    def note(self, token: Token, *, appeared: bool) -> None:
        """Add or remove a token, and call the listeners if the graph has changed."""
        if appeared:
            changed = self._add(token)
        else:
            with self._lock:
                changed = self._forget(token.key) is not None
        if changed:
            self._notify(token, appeared)

    def snapshot(self) -> Snapshot:
        """Return the graph as it is now. The first call waits for all sessions (1 to 25 ms)."""
        if not self._asks_first:
            # Watch before the query, so that no change during the query is missed.
            self.watch()
        if not self._watching:
            return Snapshot(tuple(self._query_tokens()))
        if not self._is_complete:
            self._complete()
        with self._lock:
            if self._snapshot is None:
                self._snapshot = Snapshot(tuple(self._tokens.values()))
            return self._snapshot

    def wait_for(self, condition: Callable[[Snapshot], bool], timeout_s: float | None) -> bool:
        """Wait until a condition on the graph is true.

        Return False after `timeout_s` seconds (`None`: no limit), or when the context ends.
        """
        self.watch()
        changed = BinarySemaphore()
        self._waiting.add(changed)
        deadline = Deadline(timeout_s)
        try:
            while not condition(self.snapshot()):
                if deadline.is_over or not self._is_running():
                    return False
                changed.wait(deadline.left_s)
            return True
        finally:
            self._waiting.discard(changed)

    def _complete(self) -> None:
        tokens = list(self._query_tokens())
        for token in tokens:
            if self._own not in token.key:
                self._add(token)
        with self._lock:
            # A session may remove its token after its answer.
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
        """Return the endpoint with this gid, or None if its token has not arrived yet."""
        return self._by_gid.get(gid)

    def catch_up(self) -> None:
        """Note the tokens that have arrived, in this thread (see `TokenChanges.catch_up`)."""
        self._changes.catch_up()

    def tokens_in(self, keys: Iterable[str]) -> Iterator[Token]:
        """Yield the tokens in keys. Leave out the keys that are not tokens of this dialect."""
        return filter(None, map(self._parse, keys))

    def add_listener(self, listener: Callable[[Token, bool], None]) -> None:
        """Call `listener(token, appeared)` for known tokens now, and for each change later.

        The calls end when the listener's object is deleted. Before this method, call `watch` or
        `follow`, so that this session receives tokens of other sessions.
        """
        with self._lock:
            self._listeners.append(weakref.WeakMethod(listener))
            tokens = list(self._tokens.values())
        for token in tokens:
            listener(token, True)

    def remove_listener(self, listener: Callable[[Token, bool], None]) -> None:
        """Stop calling a listener."""
        with self._lock:
            self._listeners = [ref for ref in self._listeners if ref() not in {None, listener}]

    def _query_tokens(self) -> Iterator[Token]:
        keys: Iterable[str] = ()
        with unless_closed(self._session):
            if self._asks_first:
                keys = admin_query.all_tokens(self._session, self._keys)
            else:
                keys = self._tokens_from_peers()
        yield from self.tokens_in(keys)

    def _tokens_from_peers(self) -> Iterable[str]:
        # A query is no use here: this session would answer from its own cache, which may be
        # incomplete. But after a new subscription, each peer sends its tokens before it answers the
        # query of `settle`.
        subscribers = [
            declare_subscriber(self._session, key, admin_query.large_queue()) for key in self._keys
        ]
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

    def _parse(self, key: str) -> Token | None:
        try:
            return self._dialect.parse_token(key)
        except TokenError:
            return None  # a token of a program that does not use the tokens of ROS 2

    def _on_change(self, sample: zenoh.Sample) -> None:
        key = str(sample.key_expr)
        # `announce` and `undeclare` have noted the own tokens. Zenoh delivers their samples later,
        # and an equal token may have been declared again since then.
        if self._own in key:
            return
        if sample.kind == zenoh.SampleKind.PUT:
            token = self._parse(key)
            if token is not None and self._add(token):
                self._notify(token, True)
            return
        with self._lock:
            gone = self._forget(key)
            if self._watching and not self._is_complete:
                self._gone.add(key)
        if gone is not None:
            self._notify(gone, False)

    def _add(self, token: Token) -> bool:
        with self._lock:
            if token.key in self._tokens:
                return False
            self._tokens[token.key] = token
            self._snapshot = None
            if isinstance(token, EndpointToken):
                self._by_gid[token.gid] = token
            return True

    def _notify(self, token: Token, appeared: bool) -> None:
        for changed in list(self._waiting):
            changed.set()
        for ref in list(self._listeners):
            listener = ref()
            if listener is not None:
                listener(token, appeared)


def foreign_topics(
    session: zenoh.Session, snapshot: Snapshot, domain: int
) -> dict[str, set[EntityKind]]:
    """Read the admin spaces of plain Zenoh programs. Return the topics that only they use.

    Args:
        session: A client's session.
        snapshot: The graph. The result leaves out its topics, and its sessions are not queried.
        domain: 0 to 232.
    """
    own = {token.zid for token in snapshot.tokens} | {str(session.info.zid())}
    foreign = admin_query.sessions(session, "*", _ANSWER_TIMEOUT_S).keys() - own
    # A list, so that all queries are sent before the first answer is read.
    asked = [
        admin_query.answers(session, f"@/{zid}/*/*/{domain}/**", _ANSWER_TIMEOUT_S)
        for zid in foreign
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
        return False  # the key has a wildcard, or is not a valid name in ROS 2


def full_names(tokens: Iterable[Token]) -> list[str]:
    """Return the full names of the nodes to which tokens belong."""
    return [token.full_node_name for token in tokens]
