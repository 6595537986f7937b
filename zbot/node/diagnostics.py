"""What a beginner is told without asking: typos, two types on a topic, two nodes of one name, ...

Each would otherwise be silence: both sides look healthy and nothing arrives. One thread a context
waits for the graph to change; it sleeps otherwise.
"""

from __future__ import annotations

import threading
import time
from collections import deque
from typing import TYPE_CHECKING

import zenoh

from zbot.errors import NotInitializedError
from zbot.log import get_logger
from zbot.names import fully_qualified, is_hidden, nearest
from zbot.wire.keys import SHARED_DOMAIN
from zbot.wire.tokens import EndpointToken, EntityKind, NodeToken

if TYPE_CHECKING:
    from zbot.context import Context
    from zbot.graph.snapshot import Snapshot, Token

# Programs of one lesson are started by hand, one after the other: give the other side time to come.
_PATIENCE_S = 3.0
_VERBS = {EntityKind.PUBLISHER: "publishes", EntityKind.SUBSCRIPTION: "subscribes to"}

_advisers: dict[Context, Adviser] = {}
_lock = threading.Lock()


def adviser_of(context: Context) -> Adviser:
    """Return the context's adviser, started at the first call."""
    with _lock:
        adviser = _advisers.get(context)
        if adviser is None:
            adviser = _advisers[context] = Adviser(context)
        return adviser


class Adviser:
    """Compares a context's nodes and endpoints with everybody else's; logs what looks wrong.

    Args:
        context: Whose nodes are looked after.
    """

    def __init__(self, context: Context) -> None:
        self._context = context
        self._own: dict[str, tuple[Token, str]] = {}
        self._news: deque[Token] = deque()
        self._checks: deque[tuple[float, EndpointToken, str]] = deque()
        self._said: set[tuple[str, ...]] = set()
        self._signal = threading.Condition()
        context.graph.add_listener(self._on_change)
        context.add_waker(self._wake)
        context.start_thread("zbot advice", self._run)

    def add(self, token: Token, logger_name: str) -> None:
        """Look after a node or endpoint; what is found is logged under `logger_name`."""
        with self._signal:
            self._own[token.key] = (token, logger_name)
            self._news.append(token)
            if isinstance(token, EndpointToken) and token.kind is EntityKind.SUBSCRIPTION:
                self._checks.append((time.monotonic() + _PATIENCE_S, token, logger_name))
            self._signal.notify()

    def remove(self, token: Token) -> None:
        """Look after it no more."""
        with self._signal:
            self._own.pop(token.key, None)

    def _wake(self) -> None:
        with self._signal:
            self._signal.notify()

    def _on_change(self, token: Token, appeared: bool) -> None:
        # Zenoh's thread: logging publishes on /rosout, which must not happen here.
        if appeared:
            with self._signal:
                self._news.append(token)
                self._signal.notify()

    def _run(self) -> None:
        try:
            self._advise()
        finally:
            with _lock:
                _advisers.pop(self._context, None)  # which this one would keep alive

    def _advise(self) -> None:
        while True:
            with self._signal:
                while self._context.ok() and not self._news and not self._is_check_due():
                    due = self._checks[0][0] - time.monotonic() if self._checks else None
                    self._signal.wait(due)
                if not self._context.ok():
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
                if self._context.ok():
                    raise
                return  # the session was closed while it was being asked

    def _is_check_due(self) -> bool:
        return bool(self._checks) and self._checks[0][0] <= time.monotonic()

    def _compare(self, news: list[Token]) -> None:
        with self._signal:
            own = list(self._own.values())
            has_own = any(token.key in self._own for token in news)
        others = self._context.graph.snapshot().tokens if has_own else ()
        for token in news:
            for mine, logger_name in own:
                self._compare_pair(mine, token, logger_name)
            if token.key in self._own:
                logger_name = self._own[token.key][1]
                self._check_shared(token, logger_name)
                for other in others:
                    self._compare_pair(token, other, logger_name)

    def _check_shared(self, token: Token, logger_name: str) -> None:
        """Tell a student that not everybody may speak in the space that a class shares."""
        is_speaking = token.kind in {EntityKind.PUBLISHER, EntityKind.SERVICE}
        if self._context.is_student and is_speaking and token.domain == SHARED_DOMAIN:
            self._say(
                logger_name,
                ("shared",),
                "what this node publishes in /class/ reaches others only while the teacher lets "
                "students speak there (zbot share class)",
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
            self._say(
                logger_name,
                ("node", name),
                f"there is another node named {name}; give one of them another name: "
                f"--ros-args -r __node:={mine.node}_2",
            )

    def _compare_types(self, mine: EndpointToken, other: EndpointToken, logger_name: str) -> None:
        if mine.kind not in _VERBS or other.kind not in _VERBS:
            return
        if mine.name != other.name or mine.type_name == other.type_name:
            return
        who = fully_qualified(other.namespace, other.node)
        self._say(
            logger_name,
            ("type", mine.name, mine.type_name, other.type_name),
            f"{mine.name} has two types: this node uses {mine.type_name}, but {who} "
            f"{_VERBS[other.kind]} {other.type_name}; they cannot hear each other",
        )

    def _check_silence(self, token: EndpointToken, logger_name: str) -> None:
        if token.key not in self._own or is_hidden(token.name):
            return
        snapshot = self._context.graph.snapshot()
        if snapshot.publishers(token.name):
            return
        guess = nearest(token.name, _published(snapshot, token.type_name))
        if guess is not None:
            self._say(
                logger_name,
                ("typo", token.name, guess),
                f"nobody publishes {token.name}, but {guess} ({token.type_name}) has a publisher: "
                "is one of the names misspelt?",
            )

    def _say(self, logger_name: str, about: tuple[str, ...], text: str) -> None:
        if (logger_name, *about) not in self._said:
            self._said.add((logger_name, *about))
            get_logger(logger_name).warning(text)


def _published(snapshot: Snapshot, type_name: str) -> list[str]:
    publishers = snapshot.of_kind(EntityKind.PUBLISHER)
    return sorted({end.name for end in publishers if end.type_name == type_name})
