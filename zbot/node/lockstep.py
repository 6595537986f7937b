"""Answer of a node to a simulator in lockstep: the node has done all work of an instant.

A simulator in lockstep publishes `/clock`, and asks each node that follows it. The node answers
when its executor has no more work: all messages that came before the question are handled, all
timers that are due have run, and no thread that slept on the node's clock is working. Zenoh keeps
the order of what one session sends to another one. So the messages of the instant arrive before the
question, and what the node published arrives before the answer.
"""

from __future__ import annotations

import contextlib
import time
from typing import TYPE_CHECKING, Any, Protocol

import zenoh

from zbot.executor.callback_group import ReentrantCallbackGroup
from zbot.threads.foreign_call import called_by_zenoh

if TYPE_CHECKING:
    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.clock import ROSClock
    from zbot.executor.ready_queue import ReadyQueue
    from zbot.node.state import NodeState
    from zbot.wire.tokens import EndpointToken, NodeToken

#: In a question: other nodes follow the clock, too. A node must know that its messages have arrived
#: there before it answers.
WITH_OTHERS = b"others"
#: In the parameters of a question between nodes, which is answered at once.
_ARRIVED = "arrived"
_ARRIVAL_TIMEOUT_S = 1.0
_LOOK_AGAIN_NS = 200_000


def lockstep_key(token: NodeToken | EndpointToken) -> str:
    """Return the Zenoh key on which a node answers. The token is of the node or its endpoint."""
    return f"{token.domain}/_lockstep/{token.zid}/{token.nid}"


class WorkingExecutor(Protocol):
    """The part of an executor that an answer uses."""

    @property
    def runs_callbacks(self) -> bool:
        """Whether a callback runs in another thread."""
        ...

    def has_more_work(self) -> bool:
        """Queue all entities that have work, and return whether any entity is queued."""
        ...


class LockstepAnswer:
    """Entity that answers the questions of a simulator, when the executor has no other work.

    It exists only while the node follows `/clock`, and costs nothing while nobody asks.

    Args:
        state: The state of the node.
        clock: The node's clock.
    """

    def __init__(self, state: NodeState, clock: ROSClock) -> None:
        self.callback_group: CallbackGroup = ReentrantCallbackGroup()
        self.ready_queue: ReadyQueue = state.ready_queue
        self.due_ns: int | None = None
        self._state, self._clock = state, clock
        self._key = lockstep_key(state.token)
        self._query: zenoh.Query | None = None
        self.ready_queue.add(self)
        receive: Any = zenoh.handlers.Callback(self._receive, indirect=False)
        self._queryable: Any = state.context.session.declare_queryable(self._key, receive)

    @called_by_zenoh
    def _receive(self, query: zenoh.Query) -> None:
        if str(query.parameters) == _ARRIVED:
            _answer(query, self._key, b"")
            return
        self._query = query
        self.ready_queue.post(self)

    def take(self) -> zenoh.Query | None:
        """Return the question if everything else is done. Otherwise look again after it."""
        self.due_ns = None
        if self._query is None:
            return None
        executor: Any = self.ready_queue.executor
        if self._is_busy(executor):
            # Threads may work without a post. Their end is noticed by a look from time to time.
            self.due_ns = time.monotonic_ns() + _LOOK_AGAIN_NS
            return None
        query, self._query = self._query, None
        return query

    def _is_busy(self, executor: WorkingExecutor) -> bool:
        if executor.has_more_work():
            self.ready_queue.post(self)  # after the entities that are queued now
            return True
        return executor.runs_callbacks or self._clock.sleepers.are_busy(
            self._clock.now().nanoseconds
        )

    def execute(self, query: zenoh.Query) -> None:
        """Answer with the number of messages that the program has sent so far."""
        payload = query.payload
        if payload is not None and payload.to_bytes() == WITH_OTHERS:
            self._wait_for_arrival()
        sent = sum(
            publisher.sent_count
            for node in self._state.context.nodes
            for publisher in getattr(node.handle, "publishers", ())
        )
        _answer(query, self._key, str(sent).encode())

    def _wait_for_arrival(self) -> None:
        """Wait until the messages of this session have arrived at all nodes that follow `/clock`.

        The answer of each node means this, because it comes after what was sent before.
        """
        others = f"{self._key.rsplit('/', 2)[0]}/**?{_ARRIVED}"
        options: dict[str, Any] = {"target": zenoh.QueryTarget.ALL, "timeout": _ARRIVAL_TIMEOUT_S}
        with contextlib.suppress(zenoh.ZError):
            for _ in self._state.context.session.get(others, **options):
                pass

    def destroy(self) -> None:
        """Answer no longer."""
        self.ready_queue.remove(self)
        self._query = None
        self._state.context.undeclare(self._queryable)


def _answer(query: zenoh.Query, key: str, payload: bytes) -> None:
    with contextlib.suppress(zenoh.ZError):  # the session is closed
        query.reply(key, payload)
    query.drop()
