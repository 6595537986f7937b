"""Queue of the entities that an executor runs, with their timers and their callback groups."""

from __future__ import annotations

import contextlib
import heapq
import itertools
import threading
import time
from collections import OrderedDict, deque
from typing import TYPE_CHECKING, Any

from zbot.executor.callback_group import GroupReservations
from zbot.threads.wakeup import BinarySemaphore

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from zbot.executor.ready_queue import Entity, ReadyQueue
    from zbot.executor.task import Future


class EntityQueue:
    """Entities that may have work, in the order in which they were posted.

    Any thread may post. Only the thread that spins takes work, or sleeps until the next post or
    the next timer.
    """

    def __init__(self) -> None:
        # Its methods are atomic: another thread or a signal's exception cannot come in between.
        self._ready: OrderedDict[Entity, None] = OrderedDict()
        self._groups = GroupReservations()
        self._timers = TimerQueue()
        self._wakeup = BinarySemaphore()
        # Whether the running entity goes back to the queue after its present callback. Otherwise
        # the entity's next callback runs immediately.
        self._must_requeue = True
        self._turns: deque[Future[None]] = deque()  # each is done when a callback has ended
        # The entity that the spinning thread has removed from the queue, until its callback has
        # ended or another thread runs it.
        self._current: Entity | None = None

    def _pop_turns(self) -> Iterator[Future[None]]:
        with contextlib.suppress(IndexError):
            while True:
                yield self._turns.popleft()

    def _post(self, entity: Entity) -> None:
        self._queue(entity)
        self._wakeup.set()

    def _queue(self, entity: Entity) -> None:
        # One entry for each entity is enough. No post is lost, because the entry is removed before
        # the entity is asked for work.
        if entity not in self._ready:
            self._ready[entity] = None
            self._must_requeue = True

    def _pop_ready(self) -> Entity | None:
        try:
            return self._ready.popitem(last=False)[0]
        except KeyError:
            return None

    def _pop_due_or_ready(self) -> Entity | None:
        due = self._timers.pop_due(time.monotonic_ns())
        if due is not None:
            self._queue(due)
        return self._pop_ready()

    def _take_work(self, entity: Entity) -> tuple[Entity, Any] | None:
        ready_queue = entity.ready_queue
        if ready_queue is not None and ready_queue.executor is not self:
            self._forward(entity, ready_queue)
            return None
        self._current = entity
        if not self._groups.reserve(entity):
            self._current = None
            return None  # the entity is queued again when the group is free
        try:
            taken = entity.take()
        except BaseException:  # e.g. of a program's own waitable
            self._finish(entity)
            raise
        if taken is not None:
            return entity, taken
        for waiting in self._groups.release(entity):
            self._queue(waiting)
        self._current = None
        due = entity.due_ns
        if due is not None:
            self._timers.put(entity, due)
        return None

    def _forward(self, entity: Entity, ready_queue: ReadyQueue) -> None:
        """Post an entity to the executor that its node now belongs to."""
        ready_queue.post(entity)
        for waiting in self._groups.skip(entity):
            self._queue(waiting)

    def _finish(self, entity: Entity) -> None:
        """Release an entity's callback group after its callback, and queue the entity again."""
        # Entities that the group refused go to the front of the queue, because they were selected
        # before the other entities.
        for waiting in reversed(self._groups.release(entity)):
            if waiting not in self._ready:
                self._queue(waiting)
                with contextlib.suppress(KeyError):  # another thread has just removed it
                    self._ready.move_to_end(waiting, last=False)
        self._queue(entity)  # it may have more work
        if self._turns:
            for turn in self._pop_turns():
                turn.set_result(None)

    def _abandon_current(self) -> None:
        """Let the entity begin again whose work a signal's exception has interrupted."""
        entity, self._current = self._current, None
        if entity is not None:
            self._groups.abandon(entity)
            self._queue(entity)

    def _requeue(self, entities: list[Entity]) -> None:
        """Queue entities, also if the timers wrongly seem to have them already."""
        self._timers.forget(entities)
        for entity in [*entities, *self._groups.drain()]:
            self._queue(entity)
        self._wakeup.set()

    def _discard(self, entities: list[Entity]) -> None:
        """Remove entities from the queue and from the timers."""
        self._must_requeue = True
        self._timers.forget(entities)
        # Other threads may add and remove entities during this loop. So the loop removes each
        # entity from the front once, in atomic steps. Then the loop posts the entities that stay.
        for _ in range(len(self._ready)):
            entity = EntityQueue._pop_ready(self)
            if entity is not None:
                for kept in self._groups.skip(entity) if entity in entities else [entity]:
                    self._post(kept)

    def _sleep(self, deadline_ns: int | None) -> bool:
        """Sleep until a post, a timer or the deadline. Return `False` at the deadline."""
        wakes = [due for due in (deadline_ns, self._timers.earliest_ns()) if due is not None]
        if not wakes:
            self._wakeup.wait(threading.TIMEOUT_MAX)
            return True
        left = min(wakes) - time.monotonic_ns()
        if left > 0:
            self._wakeup.wait(left / 1e9)
        return deadline_ns is None or time.monotonic_ns() < deadline_ns


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
