"""Nodes of an executor."""

from __future__ import annotations

from types import FunctionType
from typing import TYPE_CHECKING, cast

from zbot.executor.entity_queue import EntityQueue
from zbot.executor.errors import ShutdownError
from zbot.executor.set_by_init import MissingSuperInitError, set_by_init
from zbot.executor.spinnable import check_node

if TYPE_CHECKING:
    from zbot.context import Context
    from zbot.executor.ready_queue import Entity, ReadyQueue
    from zbot.executor.spinnable import NodeExecutor, SpinnableNode


class ExecutorNodes(EntityQueue):
    """Nodes of an executor, whose entities post themselves to the executor's queue.

    Args:
        context: The context of the nodes.
    """

    _nodes: list[SpinnableNode] = set_by_init()

    def __init__(self, context: Context) -> None:
        super().__init__()
        self._context = context
        self._nodes = []
        self._paused: ReadyQueue | None = None
        self._is_shutdown = False

    @property
    def is_shutdown(self) -> bool:
        """Whether the executor was shut down. After that, `add_node` raises an error."""
        return self._is_shutdown

    @property
    def context(self) -> Context:
        """The context whose shutdown ends spinning."""
        try:
            return self._context
        except AttributeError:  # each turn of a loop reads it: `set_by_init` would cost too much
            raise MissingSuperInitError(type(self), "") from None

    def add_node(self, node: SpinnableNode) -> bool:
        """Run a node's callbacks from now on. Return `False` if the node is already added.

        Raises:
            WrongObjectError: The argument is not a node.
            ShutdownError: This executor was shut down.
        """
        check_node(f"{type(self).__name__}.add_node", node)
        nodes = self._nodes
        self._require_own(node.handle.context)
        if self._is_shutdown:
            raise ShutdownError("this executor")
        if node in nodes:
            return False
        if node.executor is not None:
            node.executor.remove_node(node)
        handle = node.handle
        handle.executor = cast("NodeExecutor", self)
        if self._paused is handle.ready_queue:
            self._paused = None
        else:
            handle.ready_queue.attach(self, self._post)
        nodes.append(node)  # after the rest: a signal's exception may come in between
        return True

    @staticmethod
    def _require_own(context: Context) -> None:
        """Raise an error if a context belongs to the parent of this forked process."""
        if context.is_inherited:
            context.require_valid("this executor")

    def _require_ready(self) -> None:
        """Raise an error if `__init__` did not run, or if this is a forked child of its process."""
        self._require_own(self.context)

    def leave_to_parent(self) -> None:
        """In a forked child, end all loops. From now on, `spin` raises an error."""
        self._is_shutdown = True

    def pause_node(self, node: SpinnableNode) -> None:
        """Remove a node, but still queue the node's entities when they may have work.

        So it costs little to add the node again. The queued entities are removed when this executor
        spins without the node.
        """
        if node in self._nodes:
            self._drop_paused()
            self._nodes.remove(node)
            node.handle.executor = None
            self._paused = node.handle.ready_queue

    def _drop_paused(self) -> None:
        paused, self._paused = self._paused, None
        if paused is not None and paused.executor is self:
            paused.detach()
            self._discard(paused.entities)

    def remove_node(self, node: SpinnableNode) -> None:
        """Stop running a node's callbacks. Do nothing if this executor does not have the node."""
        if node in self._nodes:
            self._nodes.remove(node)
            node.handle.ready_queue.detach()
            node.handle.executor = None
            self._discard(node.handle.ready_queue.entities)

    def get_nodes(self) -> list[SpinnableNode]:
        """Return the nodes in the order in which they were added."""
        return list(self._nodes)

    def _entities(self) -> list[Entity]:
        """Return the entities of all nodes."""
        return [entity for node in list(self._nodes) for entity in node.handle.ready_queue.entities]

    def _node_of(self, entity: Entity) -> SpinnableNode | None:
        owners = (node for node in self._nodes if node.handle.ready_queue is entity.ready_queue)
        return next(owners, None)


# Python's errors name the class of a method: `ExecutorNodes.add_node() missing ...`. Users know
# Executor.
for _member in vars(ExecutorNodes).values():
    if isinstance(_member, FunctionType):
        _member.__qualname__ = f"Executor.{_member.__name__}"
