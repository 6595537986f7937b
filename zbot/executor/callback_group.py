"""Which callbacks may run at the same time."""

from __future__ import annotations

import contextlib
import threading
import weakref
from collections import deque
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterator


class CallbackGroup:
    """Decides whether a callback may begin while others of its group are running.

    A program's own group defines the three methods of execution. What it refuses, it is asked again
    after the executor's next callback, whichever that is, or when the executor is woken. It may be
    asked, and given back, for what turns out to have no work.
    """

    def __init__(self) -> None:
        self._entities: weakref.WeakSet[Any] = weakref.WeakSet()

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
        """Reserve the group for the entity; `False` means that it has to wait."""
        raise NotImplementedError

    def ending_execution(self, entity: Any) -> list[Any] | None:
        """Give the group back; return the entities that were made to wait, if it knows them."""
        raise NotImplementedError


class ReentrantCallbackGroup(CallbackGroup):
    """Every callback may run at any time, even beside itself."""

    def can_execute(self, entity: Any) -> bool:  # noqa: ARG002 - rclpy's signature
        """Return True."""
        return True

    def beginning_execution(self, entity: Any) -> bool:  # noqa: ARG002 - rclpy's signature
        """Return True."""
        return True

    def ending_execution(self, entity: Any) -> list[Any]:  # noqa: ARG002 - rclpy's signature
        """Return nobody: nobody ever waits."""
        return []


class MutuallyExclusiveCallbackGroup(CallbackGroup):
    """One callback of the group at a time, a coroutine's `await` included."""

    def __init__(self) -> None:
        super().__init__()
        self._lock = threading.RLock()  # re-entrant, for a signal's handler
        self._active: Any = None
        self._waiting: dict[Any, None] = {}  # in the order in which they came

    def can_execute(self, entity: Any) -> bool:  # noqa: ARG002 - rclpy's signature
        """Return whether nothing of the group is running."""
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
        """Free the group and return who has waited longest; the next is returned after that one."""
        with self._lock:
            self._active = None
            first = next(iter(self._waiting), None)
            if first is None:
                return []
            del self._waiting[first]
            return [first]

    def dismiss(self) -> list[Any]:
        """Return all that wait, where the one that was to go before them does not come."""
        with self._lock:
            waiting, self._waiting = self._waiting, {}
            return list(waiting)


_TELL_WHO_WAITED = {ReentrantCallbackGroup, MutuallyExclusiveCallbackGroup}


class Refused:
    """What an executor has to ask for again, for a program's own groups keep no list of it."""

    def __init__(self) -> None:
        self._entities: deque[Any] = deque()

    def begins(self, entity: Any) -> bool:
        """Reserve an entity's group for it; `False` means that it has to wait."""
        group: CallbackGroup = entity.callback_group
        if type(group) in _TELL_WHO_WAITED:
            return group.beginning_execution(entity)
        # First, for another thread may give the group back while it is being asked.
        self._entities.append(entity)
        if not (group.can_execute(entity) and group.beginning_execution(entity)):
            return False
        with contextlib.suppress(ValueError):
            self._entities.remove(entity)
        return True

    def ends(self, entity: Any) -> list[Any]:
        """Give an entity's group back; return those that are to be asked for again."""
        return [*(entity.callback_group.ending_execution(entity) or ()), *self.drain()]

    def skipped(self, entity: Any) -> list[Any]:
        """Return those that are to be asked again because an entity, in front of them, is not."""
        group: CallbackGroup = entity.callback_group
        return group.dismiss() if isinstance(group, MutuallyExclusiveCallbackGroup) else []

    def drain(self) -> Iterator[Any]:
        """Yield what was refused until now, each thing to one thread only."""
        with contextlib.suppress(IndexError):
            for _ in range(len(self._entities)):
                yield self._entities.popleft()
