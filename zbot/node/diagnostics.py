"""Warnings about typical mistakes: misspelt topics, two types on a topic, equal names of nodes.

Without a warning, the programs seem to work, but no message arrives. One thread per context waits
for changes of the graph.
"""

from __future__ import annotations

import threading
from collections import deque
from typing import TYPE_CHECKING

import zenoh

from zbot.errors import NotInitializedError
from zbot.errors.suggestion import nearest
from zbot.graph.snapshot import Snapshot
from zbot.log import get_logger
from zbot.names import ROSOUT_TOPIC, fully_qualified, is_hidden
from zbot.process import fork
from zbot.threads.deadline import Deadline
from zbot.transport import running_programs
from zbot.wire.keys import SHARED_DOMAIN
from zbot.wire.tokens import EndpointToken, EntityKind, NodeToken

if TYPE_CHECKING:
    from zbot.context import Context
    from zbot.graph.snapshot import Token

# A missing publisher is reported after this time, because its program may start a bit later.
_CHECK_DELAY_S = 3.0
_STANDARD_TYPES = {
    ROSOUT_TOPIC: "rcl_interfaces/msg/Log",
    "/parameter_events": "rcl_interfaces/msg/ParameterEvent",
}
_VERBS = {EntityKind.PUBLISHER: "publishes", EntityKind.SUBSCRIPTION: "subscribes to"}

_PAIRS = (
    {EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION},
    {EntityKind.SERVICE, EntityKind.CLIENT},
)

_of_contexts: dict[Context, Diagnostics] = {}
_lock = threading.Lock()


def _leave_to_parent() -> None:
    global _lock  # noqa: PLW0603 - there is one per process
    fork.keep(dict(_of_contexts))
    _lock = threading.Lock()
    _of_contexts.clear()


fork.in_child.append(_leave_to_parent)


def diagnostics_of(context: Context) -> Diagnostics:
    """Return the diagnostics of a context. The first call starts them."""
    with _lock:
        diagnostics = _of_contexts.get(context)
        if diagnostics is None:
            diagnostics = _of_contexts[context] = Diagnostics(context)
        return diagnostics


class Diagnostics:
    """Compares a context's nodes and endpoints with all others, and logs likely mistakes.

    Args:
        context: The context whose nodes and endpoints are checked.
    """

    def __init__(self, context: Context) -> None:
        self._context = context
        self._own: dict[str, tuple[Token, str]] = {}
        self._news: deque[Token] = deque()
        self._checks: deque[tuple[Deadline, EndpointToken, str]] = deque()
        self._warned: set[tuple[str, ...]] = set()
        self._signal = threading.Condition()
        context.graph.add_listener(self._on_change)
        context.add_waker(self._wake)
        context.start_thread("zbot diagnostics", self._run)

    def add(self, token: Token, logger_name: str) -> None:
        """Check a node or endpoint from now on. Warnings are logged under `logger_name`."""
        if _is_standard(token):
            return
        self._context.graph.follow(token)
        with self._signal:
            self._own[token.key] = (token, logger_name)
            self._news.append(token)
            if isinstance(token, EndpointToken) and token.kind is EntityKind.SUBSCRIPTION:
                self._checks.append((Deadline(_CHECK_DELAY_S), token, logger_name))
            self._signal.notify()

    def remove(self, token: Token) -> None:
        """Stop checking a node or endpoint."""
        with self._signal:
            self._own.pop(token.key, None)

    def _wake(self) -> None:
        with self._signal:
            self._signal.notify()

    def _on_change(self, token: Token, appeared: bool) -> None:
        # Zenoh's thread runs this. It must not log, because logging publishes on /rosout.
        if appeared:
            with self._signal:
                self._news.append(token)
                self._signal.notify()

    def _run(self) -> None:
        try:
            self._watch_graph()
        finally:
            with _lock:
                _of_contexts.pop(self._context, None)  # an entry would keep the context alive

    def _watch_graph(self) -> None:
        while True:
            with self._signal:
                while self._context.is_running and not self._news and not self._is_check_due():
                    self._signal.wait(self._checks[0][0].left_s if self._checks else None)
                if not self._context.is_running:
                    return
                news, self._news = list(self._news), deque()
                checks = []
                while self._is_check_due():
                    checks.append(self._checks.popleft())
            try:
                self._compare(news)
                for _, token, logger_name in checks:
                    self._check_silence(token, logger_name)
            except (zenoh.ZError, NotInitializedError):
                if self._context.is_running:
                    raise
                return  # the session was closed during a query

    def _is_check_due(self) -> bool:
        return bool(self._checks) and self._checks[0][0].is_over

    def _compare(self, news: list[Token]) -> None:
        with self._signal:
            own = list(self._own.values())
            has_own = any(token.key in self._own for token in news)
        self._check_stopped(
            {
                fully_qualified(token.namespace, token.node): logger_name
                for token, logger_name in own
                if isinstance(token, NodeToken) and token in news
            }
        )
        others = self._context.graph.known() if has_own else ()
        for token in news:
            for mine, logger_name in own:
                self._compare_pair(mine, token, logger_name)
            if token.key in self._own:
                logger_name = self._own[token.key][1]
                self._check_shared(token, logger_name)
                for other in others:
                    self._compare_pair(token, other, logger_name)

    def _check_shared(self, token: Token, logger_name: str) -> None:
        """Warn that others get a student's messages below /class/ only if the teacher allows it."""
        is_speaking = token.kind in {EntityKind.PUBLISHER, EntityKind.SERVICE}
        if self._context.is_student and is_speaking and token.domain == SHARED_DOMAIN:
            self._warn(
                logger_name,
                ("shared",),
                "others receive what this node sends in /class/ only after the teacher "
                "allowed it with: zbot share class",
            )

    def _compare_pair(self, mine: Token, other: Token, logger_name: str) -> None:
        if mine.key == other.key:
            return
        if isinstance(mine, NodeToken) and isinstance(other, NodeToken):
            self._compare_nodes(mine, other, logger_name)
        elif isinstance(mine, EndpointToken) and isinstance(other, EndpointToken):
            self._compare_types(mine, other, logger_name)

    def _compare_nodes(self, mine: NodeToken, other: NodeToken, logger_name: str) -> None:
        name = fully_qualified(mine.namespace, mine.node)
        if name == fully_qualified(other.namespace, other.node):
            self._warn(
                logger_name,
                ("node", name),
                f"there is another node named {name}; give one of them another name: "
                f"--ros-args -r __node:={mine.node}_2",
            )

    def _check_stopped(self, nodes: dict[str, str]) -> None:
        """Warn if a program that Ctrl-Z has stopped has a node of the same name.

        A stopped program does not answer, so the graph may not show its nodes.

        Args:
            nodes: The full names of own nodes, each with the name of its logger.
        """
        for name, logger_name in nodes.items():
            text = running_programs.stopped_text(self._context.get_domain_id(), name)
            if text:
                self._warn(logger_name, ("stopped", name), f"another node has this name: {text}")

    def _compare_types(self, mine: EndpointToken, other: EndpointToken, logger_name: str) -> None:
        if self._context.dialect.needs_equal_types and {mine.kind, other.kind} in _PAIRS:
            self._compare_definitions(mine, other, logger_name)
        if mine.kind not in _VERBS or other.kind not in _VERBS:
            return
        if mine.name != other.name or mine.type_name == other.type_name:
            return
        who = fully_qualified(other.namespace, other.node)
        self._warn(
            logger_name,
            ("type", mine.name, mine.type_name, other.type_name),
            f"{mine.name} has two types: this node uses {mine.type_name}, but {who} "
            f"{_VERBS[other.kind]} {other.type_name}; they cannot receive each other's messages",
        )

    def _compare_definitions(
        self, mine: EndpointToken, other: EndpointToken, logger_name: str
    ) -> None:
        is_same_type = (mine.name, mine.type_name) == (other.name, other.type_name)
        about = ("definition", mine.name, mine.type_hash, other.type_hash)
        if not is_same_type or mine.type_hash == other.type_hash:
            return
        if (logger_name, *about) not in self._warned:
            from zbot.node.type_difference import difference_text  # noqa: PLC0415 - rarely needed

            self._warn(logger_name, about, difference_text(self._context, mine, other))

    def _check_silence(self, token: EndpointToken, logger_name: str) -> None:
        # A node of a command has a hidden name, which contains `/_` or begins with `_`. It needs no
        # warning here, because the command itself reports a topic without a publisher.
        if token.key not in self._own or is_hidden(token.name) or is_hidden(token.node):
            return
        if Snapshot(self._context.graph.known()).publishers(token.name):
            return
        if self._warn_of_unreachable(token, logger_name):
            return
        snapshot = self._context.graph.query()
        guess = nearest(token.name, _published(snapshot, token.type_name))
        if guess is not None:
            self._warn(
                logger_name,
                ("typo", token.name, guess),
                f"nobody publishes {token.name}, but {guess} ({token.type_name}) has a publisher: "
                "is one of the names misspelt?",
            )

    def _warn_of_unreachable(self, token: EndpointToken, logger_name: str) -> bool:
        """Warn if a publisher's messages can reach the router, but not this program.

        Returns:
            Whether the topic has such a publisher.
        """
        unreachable = Snapshot(tuple(self._context.unreachable_tokens()))
        publishers = unreachable.publishers(token.name)
        for publisher in publishers[:1]:
            who = fully_qualified(publisher.namespace, publisher.node)
            self._warn(
                logger_name,
                ("link", token.name),
                f"nothing is heard from {who} on {token.name}, because there is no way from it "
                "to this program, and routers of ROS 2 pass nothing on between two peers: set "
                "ZENOH_CONFIG_OVERRIDE='mode=\"client\"' for this program",
            )
        return bool(publishers)

    def _warn(self, logger_name: str, about: tuple[str, ...], text: str) -> None:
        if (logger_name, *about) not in self._warned:
            self._warned.add((logger_name, *about))
            get_logger(logger_name).warning(text)


def _is_standard(token: Token) -> bool:
    """Return whether this is a publisher of every node, e.g. of /rosout. It needs no check."""
    if not isinstance(token, EndpointToken) or token.kind is not EntityKind.PUBLISHER:
        return False
    return token.type_name == _STANDARD_TYPES.get(token.name)


def _published(snapshot: Snapshot, type_name: str) -> list[str]:
    publishers = snapshot.of_kind(EntityKind.PUBLISHER)
    return sorted({end.name for end in publishers if end.type_name == type_name})
