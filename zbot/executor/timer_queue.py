"""What wants to run when: the timers of an executor."""

from __future__ import annotations

import heapq
import itertools
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.executor.ready_queue import Entity


class TimerQueue:
    """Entities that want to run later, each at one time, the earliest first.

    For the spinning thread alone, but for `forget`.
    """

    def __init__(self) -> None:
        self._heap: list[tuple[int, int, Entity]] = []
        self._due: dict[Entity, int] = {}
        self._tie = itertools.count()  # equal times are served in order, entities not compared

    def put(self, entity: Entity, due_ns: int) -> None:
        """Note when an entity wants to run, in place of what it wanted before."""
        if self._due.get(entity) == due_ns:
            return
        self._due[entity] = due_ns
        heapq.heappush(self._heap, (due_ns, next(self._tie), entity))
        # A timer that is reset with every message leaves an outdated entry each time.
        if len(self._heap) > 2 * len(self._due) + 64:
            self._heap = [(due, next(self._tie), entity) for entity, due in list(self._due.items())]
            heapq.heapify(self._heap)

    def earliest_ns(self) -> int | None:
        """Return when the first entity wants to run."""
        while self._heap and self._due.get(self._heap[0][2]) != self._heap[0][0]:
            heapq.heappop(self._heap)
        return self._heap[0][0] if self._heap else None

    def pop_due(self, now_ns: int) -> Entity | None:
        """Take out an entity whose time has come."""
        earliest = self.earliest_ns()
        if earliest is None or earliest > now_ns:
            return None
        entity = heapq.heappop(self._heap)[2]
        self._due.pop(entity, None)
        return entity

    def forget(self, entities: Iterable[Entity]) -> None:
        """Forget entities; from any thread."""
        for entity in entities:
            self._due.pop(entity, None)
