"""Callback groups: they decide which callbacks may run at the same time."""

from __future__ import annotations

import contextlib
import threading
import weakref
from collections import deque
from typing import TYPE_CHECKING, Any

from zbot.executor.set_by_init import set_by_init

if TYPE_CHECKING:
    from collections.abc import Iterator


class CallbackGroup:
    """Decides whether a callback may begin while other callbacks of its group are running.

    A program may have its own subclass, which defines `can_execute`, `beginning_execution` and
    `ending_execution`. If such a group refuses an entity, the executor asks the group again after
    the next callback, or when another thread wakes the executor. An executor may also reserve and
    release the group for an entity that has no work.
    """

    _entities: weakref.WeakSet[Any] = set_by_init()

    def __init__(self) -> None:
        self._entities = weakref.WeakSet()

    @property
    def entities(self) -> set[weakref.ref[Any]]:
        """Weak references to the entities of the group, as in rclpy."""
        return {weakref.ref(entity) for entity in self._entities}

    def add_entity(self, entity: Any) -> None:
        """Put a subscription, timer, service ... into the group."""
        self._entities.add(entity)

    def has_entity(self, entity: Any) -> bool:
        """Return whether the entity belongs to the group."""
        return entity in self._entities

    def can_execute(self, entity: Any) -> bool:
        """Return whether the entity's callback could begin now."""
        raise NotImplementedError

    def beginning_execution(self, entity: Any) -> bool:
        """Reserve the group for the entity. Return `False` if the entity has to wait."""
        raise NotImplementedError

    def ending_execution(self, entity: Any) -> list[Any] | None:
        """Release the group. Return the entities that wait, or `None` if they are unknown."""
        raise NotImplementedError


class ReentrantCallbackGroup(CallbackGroup):
    """Group whose callbacks may run at any time, even several times in parallel."""

    def can_execute(self, entity: Any) -> bool:  # noqa: ARG002 - rclpy's signature
        """Return True."""
        return True

    def beginning_execution(self, entity: Any) -> bool:  # noqa: ARG002 - rclpy's signature
        """Return True."""
        return True

    def ending_execution(self, entity: Any) -> list[Any]:  # noqa: ARG002 - rclpy's signature
        """Return an empty list: no entity ever waits."""
        return []


class MutuallyExclusiveCallbackGroup(CallbackGroup):
    """Group that runs one callback at a time. A coroutine that awaits counts as running."""

    def __init__(self) -> None:
        super().__init__()
        self._lock = threading.RLock()  # re-entrant, because a signal handler may use it
        self._active: Any = None
        self._waiting: dict[Any, None] = {}  # in the order of their requests

    def can_execute(self, entity: Any) -> bool:  # noqa: ARG002 - rclpy's signature
        """Return whether no callback of the group is running."""
        return self._active is None

    def beginning_execution(self, entity: Any) -> bool:
        """Reserve the group, or note the entity as waiting and return `False`."""
        with self._lock:
            if self._active is None:
                self._active = entity
                return True
            self._waiting[entity] = None
            return False

    def ending_execution(self, entity: Any) -> list[Any]:  # noqa: ARG002 - rclpy's signature
        """Release the group and return the entity that has waited longest, if any."""
        with self._lock:
            self._active = None
            first = next(iter(self._waiting), None)
            if first is None:
                return []
            del self._waiting[first]
            return [first]

    def is_reserved_for(self, entity: Any) -> bool:
        """Return whether the group is reserved for the entity."""
        return self._active is entity

    def dismiss(self) -> list[Any]:
        """Return all waiting entities, because the entity that they wait for will never run."""
        with self._lock:
            waiting, self._waiting = self._waiting, {}
            return list(waiting)


#: The groups whose `ending_execution` returns the entities that wait.
_KNOW_WAITING = {ReentrantCallbackGroup, MutuallyExclusiveCallbackGroup}


class GroupReservations:
    """Reserves callback groups for an executor's entities.

    This object keeps the entities that a program's own group refused, because such a group does not
    keep them itself.
    """

    def __init__(self) -> None:
        self._entities: deque[Any] = deque()

    def reserve(self, entity: Any) -> bool:
        """Reserve an entity's group for the entity. Return `False` if the entity has to wait."""
        group: CallbackGroup = entity.callback_group
        if type(group) in _KNOW_WAITING:
            return group.beginning_execution(entity)
        # Store the entity first: another thread may release the group while the group is asked.
        self._entities.append(entity)
        if not (group.can_execute(entity) and group.beginning_execution(entity)):
            return False
        with contextlib.suppress(ValueError):
            self._entities.remove(entity)
        return True

    def release(self, entity: Any) -> list[Any]:
        """Release an entity's group. Return the entities that must be queued again."""
        waiting = entity.callback_group.ending_execution(entity) or ()
        return [*waiting, *self.drain()] if self._entities else list(waiting)

    def abandon(self, entity: Any) -> None:
        """Release an entity's group if it is still reserved for the entity.

        All entities of the executor must be queued again after this. Only a
        `MutuallyExclusiveCallbackGroup` knows for which entity it is reserved.
        """
        group: CallbackGroup = entity.callback_group
        if isinstance(group, MutuallyExclusiveCallbackGroup) and group.is_reserved_for(entity):
            group.ending_execution(entity)

    def skip(self, entity: Any) -> list[Any]:
        """Return the entities that must be queued again, because this entity will not run."""
        group: CallbackGroup = entity.callback_group
        return group.dismiss() if isinstance(group, MutuallyExclusiveCallbackGroup) else []

    def drain(self) -> Iterator[Any]:
        """Yield and forget the entities that groups refused. Each goes to one thread only."""
        with contextlib.suppress(IndexError):
            for _ in range(len(self._entities)):
                yield self._entities.popleft()
