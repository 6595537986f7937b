"""Record of the nodes that run in the domains of a class."""

from __future__ import annotations

import itertools
import threading
from typing import TYPE_CHECKING

import zenoh

from zbot.classroom.keys import MAX_LISTED_NODES
from zbot.names import is_hidden
from zbot.transport.admin_query import large_queue
from zbot.wire.tokens import NodeToken, parse_token

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.classroom.hub.process import HubProcess

_MAX_LENGTH = 255  # characters of a name, as in ROS 2
_NODE_TOKENS = "@zbot/*/*/*/*/NN/**"


class RunningNodes:
    """Names of the running nodes by domain. All methods may be called from any thread.

    The names are collected while tokens come and go. A query for all tokens could last very long,
    because a student's program may declare any number of tokens.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._names: dict[int, dict[str, str]] = {}

    def watch(self, serving: HubProcess) -> None:
        """Forget all nodes. Collect the nodes that a hub sees, until the hub closes."""
        names: dict[int, dict[str, str]] = {}  # an older thread uses another dictionary
        with self._lock:
            self._names = names
        # The tokens go to a queue, not to a callback: Zenoh calls a callback while Zenoh holds the
        # hub's lock, so thousands of tokens together would stop the hub. `history` means that
        # tokens which exist already are reported too.
        subscriber = serving.session.liveliness().declare_subscriber(
            _NODE_TOKENS, large_queue(), history=True
        )
        serving.keep(subscriber)
        serving.start_thread("zbot running nodes", self._run, subscriber.handler.recv, names)

    def _run(self, receive: Callable[[], zenoh.Sample], names: dict[int, dict[str, str]]) -> None:
        while True:
            try:
                sample = receive()
            except zenoh.ZError:
                return  # the session was closed
            self._note(names, str(sample.key_expr), sample.kind == zenoh.SampleKind.PUT)

    def _note(self, names: dict[int, dict[str, str]], key: str, appeared: bool) -> None:
        token = _node_of(key)
        if token is None:
            return
        name = token.full_node_name
        if is_hidden(name) or len(name) > _MAX_LENGTH:
            return
        with self._lock:
            domain = names.setdefault(token.domain, {})
            if appeared:
                domain[key] = name
            else:
                domain.pop(key, None)

    def listed(self, domain: int) -> tuple[list[str], int]:
        """Return the full names of a domain's nodes, and how many more of its nodes run.

        At most `MAX_LISTED_NODES` names are returned. Hidden nodes are left out.
        """
        with self._lock:
            names = self._names.get(domain, {})
            first = sorted(itertools.islice(names.values(), MAX_LISTED_NODES))
            return first, len(names) - len(first)


def _node_of(key: str) -> NodeToken | None:
    try:
        token = parse_token(key)
    except ValueError:
        return None  # a student's program may declare any token in its domain
    return token if isinstance(token, NodeToken) else None
