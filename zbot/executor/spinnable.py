"""Protocols of a node and its state, as executors use them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

from zbot.executor.errors import not_a_node_error
from zbot.executor.set_by_init import MissingSuperInitError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.context import Context
    from zbot.executor.ready_queue import Entity, ReadyQueue
    from zbot.executor.waitable import WaitableEntity


def check_node(call: str, value: Any) -> None:
    """Check that an argument is a node, and neither the class of a node nor something else.

    Raises:
        WrongObjectError: The argument is not a node.
        MissingSuperInitError: The node's class did not call `super().__init__()`.
    """
    try:
        is_node = not isinstance(value, type) and value.handle is not None
    except MissingSuperInitError:
        raise
    except AttributeError:
        is_node = False
    if not is_node:
        raise not_a_node_error(call, value) from None


class NodeExecutor(Protocol):
    """The part of an executor that its nodes and their callbacks use."""

    @property
    def context(self) -> Context:
        """The context whose shutdown ends spinning."""
        ...

    def get_nodes(self) -> list[SpinnableNode]:
        """Return the nodes in the order in which they were added."""
        ...

    def remove_node(self, node: SpinnableNode) -> None:
        """Stop running a node's callbacks."""
        ...

    def serve(self, entity: Entity) -> bool:
        """Run one piece of an entity's work inside the present callback, if it has work."""
        ...

    def leave_to_parent(self) -> None:
        """In a forked child, end all loops."""
        ...


class SpinnableState(Protocol):
    """The part of a node's state that an executor uses."""

    context: Context
    executor: NodeExecutor | None

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
    def executor(self) -> NodeExecutor | None:
        """The executor that runs the node's callbacks, if any."""
        ...

    def get_name(self) -> str:
        """Return the node's base name."""
        ...

    def get_namespace(self) -> str:
        """Return the node's absolute namespace."""
        ...
