"""Protocols of a node and its state, as executors use them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.executor.executor import Executor
    from zbot.executor.ready_queue import ReadyQueue
    from zbot.executor.waitable import WaitableEntity


class SpinnableState(Protocol):
    """The part of a node's state that an executor uses."""

    executor: Executor | None

    @property
    def ready_queue(self) -> ReadyQueue:
        """The queue to which the node's entities post themselves when they may have work."""
        ...

    @property
    def waitables(self) -> Sequence[WaitableEntity]:
        """The waitables that the program added."""
        ...

    @property
    def services(self) -> Sequence[Any]:
        """The node's service servers."""
        ...


class SpinnableNode(Protocol):
    """The part of a node that an executor uses."""

    @property
    def handle(self) -> SpinnableState:
        """The node's state."""
        ...

    @property
    def executor(self) -> Executor | None:
        """The executor that runs the node's callbacks, if any."""
        ...

    def get_name(self) -> str:
        """Return the node's base name."""
        ...

    def get_namespace(self) -> str:
        """Return the node's absolute namespace."""
        ...
