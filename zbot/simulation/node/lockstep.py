"""Lockstep of a simulator with the nodes that follow its `/clock`.

After each message, the simulator asks these nodes whether they have done all their work, and waits
for their answers (`zbot/node/lockstep.py`). So each node does the same work at the same time of the
world in each run, however fast the machine is.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

import zenoh

from zbot.node.lockstep import WITH_OTHERS, lockstep_key
from zbot.threads.deadline import Deadline
from zbot.threads.foreign_call import called_by_zenoh

if TYPE_CHECKING:
    from zbot.context import Context
    from zbot.executor.executor import Executor
    from zbot.graph.snapshot import Snapshot
    from zbot.node.state import NodeState
    from zbot.wire.tokens import EndpointToken

#: Seconds after which the world goes on without a node that has not answered.
LIMIT_S = 5.0
_NEVER_S = 86_400.0


class AskingNode(Protocol):
    """The part of the simulator that a lockstep uses."""

    @property
    def handle(self) -> NodeState:
        """The node's internal state."""
        ...

    @property
    def context(self) -> Context:
        """The context of the node."""
        ...

    @property
    def executor(self) -> Any:
        """The executor that spins the node."""
        ...

    def get_logger(self) -> Any:
        """Return the node's logger."""
        ...


class Follower:
    """Node that follows `/clock`.

    Args:
        context: The context of the simulator.
        token: The node's subscription to `/clock`.

    Attributes:
        sent: How many messages its program had sent at the last answer.
        is_late: Whether the world goes on without the node.
    """

    def __init__(self, context: Context, token: EndpointToken) -> None:
        self.name = token.full_node_name
        self.sent = -1
        self.is_late = False
        self._answer: str | None = None
        self._is_asked = False
        self._wake: Any = bool
        self._querier: Any = context.session.declare_querier(lockstep_key(token), timeout=_NEVER_S)

    @property
    def answers(self) -> bool:
        """Whether the node is one that answers. Recorders and other programs are not."""
        return self._is_asked or bool(self._querier.matching_status.matching)

    @property
    def is_done(self) -> bool:
        """Whether the node has answered the last question."""
        return not self._is_asked

    def ask(self, wake: Any, payload: bytes) -> None:
        """Ask the node. `wake` is called when it has answered, or is gone."""
        if self._is_asked:
            return
        self._is_asked, self._answer, self._wake = True, None, wake
        handler: Any = zenoh.handlers.Callback(self._hear, drop=self._end, indirect=False)
        self._querier.get(handler, payload=payload)

    @called_by_zenoh
    def _hear(self, reply: zenoh.Reply) -> None:
        if reply.ok is not None:
            self._answer = reply.ok.payload.to_string()

    @called_by_zenoh
    def _end(self) -> None:
        self._is_asked = False
        self._wake()

    def has_sent_more(self) -> bool:
        """Return whether the program has sent messages since the last call."""
        before, self.sent = self.sent, int(self._answer or -1)
        return self.sent != before

    def release(self) -> None:
        """Forget the node."""
        self._querier.undeclare()


class Lockstep:
    """Lockstep of one simulator.

    Args:
        node: The simulator. Its executor handles messages and services during a wait.
        limit_s: Seconds after which the world goes on without a node that has not answered.

    Attributes:
        limit_s: The limit.
        followers: The nodes that follow the clock, by the keys of their subscriptions.
        has_changed: Whether nodes or topics have come or gone. Who reads it sets it back.
    """

    def __init__(self, node: AskingNode, limit_s: float = LIMIT_S) -> None:
        self._node, self.limit_s = node, limit_s
        self._known: Snapshot | None = None
        self.has_changed = True
        self.followers: dict[str, Follower] = {}

    @property
    def present(self) -> list[Follower]:
        """The nodes that answer, and those that are late."""
        return [follower for follower in self.followers.values() if follower.answers]

    @property
    def late(self) -> list[str]:
        """The names of the nodes without which the world goes on."""
        return [follower.name for follower in self.followers.values() if follower.is_late]

    def notice_changes(self) -> bool:
        """Look for nodes that have come or gone. Return whether the graph has changed."""
        graph = self._node.context.graph
        graph.catch_up()
        snapshot = graph.snapshot()
        if snapshot is self._known:
            return False
        self.has_changed = True
        self._known, own = snapshot, self._node.handle.token
        found = {
            token.key: token
            for token in snapshot.subscriptions("/clock")
            if (token.zid, token.nid) != (own.zid, own.nid)
        }
        for key in self.followers.keys() - found.keys():
            self.followers.pop(key).release()
        for key in found.keys() - self.followers.keys():
            self.followers[key] = Follower(self._node.context, found[key])
        return True

    def settle(self, now_ns: int) -> None:
        """Wait until all nodes have done their work, and the simulator has got their messages."""
        while True:
            self.notice_changes()
            asked = self._ask(now_ns)
            has_received = self._handle_messages()
            # Messages lead to more work, at other nodes or as answers of services.
            has_sent = [follower.has_sent_more() for follower in asked]
            if not has_received and not (len(asked) > 1 and any(has_sent)):
                return

    def _ask(self, now_ns: int) -> list[Follower]:
        """Ask all nodes, and return those that have answered."""
        executor: Executor = self._node.executor
        answered = executor.create_future()
        followers = self.present

        def wake() -> None:
            is_over = all(follower.is_done or follower.is_late for follower in followers)
            if is_over and not answered.done():
                answered.set_result(None)

        payload = WITH_OTHERS if len(followers) > 1 else b""
        for follower in followers:
            if follower.is_late and follower.is_done:
                follower.is_late = False
                self._node.get_logger().info(f"{follower.name} answers again")
            follower.ask(wake, payload)
        waiting = [follower for follower in followers if not follower.is_late]
        deadline = Deadline(self.limit_s)
        while not all(follower.is_done for follower in waiting):
            if deadline.is_over:
                self._leave_late(waiting, now_ns)
                break
            executor.spin_until_future_complete(answered, deadline.left_s)
        return [follower for follower in waiting if follower.is_done]

    def _leave_late(self, followers: list[Follower], now_ns: int) -> None:
        for follower in followers:
            if not follower.is_done:
                follower.is_late = True
                self._node.get_logger().warning(
                    f"{follower.name} is not done with the time {now_ns / 1e9:.3f} s after "
                    f"{self.limit_s:g} s: the world goes on without waiting for it"
                )

    def _handle_messages(self) -> bool:
        """Handle all that has arrived. Return whether there was anything."""
        executor: Executor = self._node.executor
        has_received = False
        while executor.has_more_work():
            has_received = True
            executor.spin_once(0)
        return has_received
