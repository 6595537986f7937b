"""Queue of an executor's timers, ordered by the time at which they are due."""

from __future__ import annotations

import heapq
import itertools
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.executor.ready_queue import Entity


class TimerQueue:
    """Entities that are due later. Each entity has one time, and the earliest is first.

    Any thread may call `forget`. Only the spinning thread may call the other methods.
    """

    def __init__(self) -> None:
        self._heap: list[tuple[int, int, Entity]] = []
        self._due: dict[Entity, int] = {}
        self._tie = itertools.count()  # order at equal times, because entities cannot be compared

    def put(self, entity: Entity, due_ns: int) -> None:
        """Set the time at which an entity is due. This replaces a time that was set before."""
        if self._due.get(entity) == due_ns:
            return
        self._due[entity] = due_ns
        heapq.heappush(self._heap, (due_ns, next(self._tie), entity))
        # Each reset of a timer leaves an outdated entry. Remove these entries if there are many.
        if len(self._heap) > 2 * len(self._due) + 64:
            self._heap = [(due, next(self._tie), entity) for entity, due in list(self._due.items())]
            heapq.heapify(self._heap)

    def earliest_ns(self) -> int | None:
        """Return the time at which the first entity is due, or `None` if the queue is empty."""
        while self._heap and self._due.get(self._heap[0][2]) != self._heap[0][0]:
            heapq.heappop(self._heap)
        return self._heap[0][0] if self._heap else None

    def pop_due(self, now_ns: int) -> Entity | None:
        """Remove and return an entity that is due. Return `None` if no entity is due."""
        earliest = self.earliest_ns()
        if earliest is None or earliest > now_ns:
            return None
        entity = heapq.heappop(self._heap)[2]
        self._due.pop(entity, None)
        return entity

    def forget(self, entities: Iterable[Entity]) -> None:
        """Remove entities. Any thread may call this."""
        for entity in entities:
            self._due.pop(entity, None)
