"""Protocol of a node as executors see it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.executor.executor import Executor
    from zbot.executor.ready_queue import ReadyQueue
    from zbot.executor.waitable import WaitableEntity


class SpinnableState(Protocol):
    """What an executor uses of a node's inner part."""

    executor: Executor | None

    @property
    def ready_queue(self) -> ReadyQueue:
        """The queue through which the node's entities ask to be run."""
        ...

    @property
    def waitables(self) -> Sequence[WaitableEntity]:
        """The entities that a program made itself."""
        ...

    @property
    def services(self) -> Sequence[Any]:
        """The node's service servers."""
        ...


class SpinnableNode(Protocol):
    """What an executor uses of a node."""

    @property
    def handle(self) -> SpinnableState:
        """The node's inner part."""
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
