"""Wait set: waits for several objects without an executor."""

from __future__ import annotations

import threading
import time
from typing import TYPE_CHECKING, Any, Literal

from zbot.executor.forgotten_spin import Program
from zbot.threads.wakeup import BinarySemaphore

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.threads.handle import Handle

Kind = Literal["subscription", "guard_condition", "timer", "client", "service", "event"]
_POLL_S = 0.1  # time between two checks, if a timer has simulated time and no known due time


class WaitSet:
    """Waits until at least one of several objects is ready.

    `Node.create_subscription` and similar methods make the objects. A program adds an object by its
    `handle`.

    Args:
        sizes: rclpy's numbers of objects of each kind, and the context's handle. They are not used.
    """

    def __init__(self, *sizes: object) -> None:  # noqa: ARG002 - rclpy's signature
        self._handles: dict[str, list[Handle[Any]]] = {}
        self._ready: dict[str, list[Handle[Any]]] = {}

    def clear_entities(self) -> None:
        """Remove all objects."""
        self._handles.clear()
        self._ready.clear()

    def add_subscription(self, handle: Handle[Any]) -> int:
        """Add a subscription and return its index for `is_ready`."""
        return self._add("subscription", handle)

    def add_guard_condition(self, handle: Handle[Any]) -> int:
        """Add a guard condition and return its index."""
        return self._add("guard_condition", handle)

    def add_timer(self, handle: Handle[Any]) -> int:
        """Add a timer and return its index."""
        return self._add("timer", handle)

    def add_client(self, handle: Handle[Any]) -> int:
        """Add a client and return its index. The wait set waits for its responses."""
        return self._add("client", handle)

    def add_service(self, handle: Handle[Any]) -> int:
        """Add a service and return its index. The wait set waits for its requests."""
        return self._add("service", handle)

    def add_event(self, handle: Handle[Any]) -> int:
        """Add a QoS event and return its index."""
        return self._add("event", handle)

    def _add(self, kind: Kind, handle: Handle[Any]) -> int:
        handles = self._handles.setdefault(kind, [])
        handles.append(handle)
        return len(handles) - 1

    def wait(self, timeout_nsec: int) -> None:
        """Wait until an object is ready, at most `timeout_nsec` nanoseconds (below 0: no limit)."""
        Program.takes_itself = True
        woken = BinarySemaphore()
        deadline = None if timeout_nsec < 0 else time.monotonic_ns() + timeout_nsec
        self.remember_waker(woken.set)
        try:
            while not self._update_ready():
                left = self._left_s(deadline)
                if left <= 0 and self._is_over(deadline):
                    return
                woken.wait(max(left, 0.0))
        finally:
            self.forget_waker(woken.set)

    @staticmethod
    def _is_over(deadline: int | None) -> bool:
        return deadline is not None and time.monotonic_ns() >= deadline

    def _left_s(self, deadline: int | None) -> float:
        ends = [end for end in (deadline, self.due_ns) if end is not None]
        left = (min(ends) - time.monotonic_ns()) / 1e9 if ends else threading.TIMEOUT_MAX
        if self._handles.get("timer") and self.due_ns is None:
            return min(left, _POLL_S)
        return left

    def _update_ready(self) -> bool:
        """Store which objects are ready, and reset the guard conditions that were triggered."""
        self._ready = {
            kind: [handle for handle in handles if handle.entity.has_work]
            for kind, handles in self._handles.items()
        }
        for handle in self._ready.get("guard_condition", ()):
            handle.entity.take()
        return any(self._ready.values())

    def is_ready(self, kind: Kind, index: int) -> bool:
        """Return whether an object was ready at the end of the last `wait`."""
        return self._handles[kind][index] in self._ready.get(kind, ())

    def get_ready_entities(self, kind: Kind) -> list[int]:
        """Return the `pointer` of each handle that was ready at the end of the last `wait`."""
        return [handle.pointer for handle in self._ready.get(kind, ())]

    @property
    def due_ns(self) -> int | None:
        """When the first timer or event is due (monotonic clock, nanoseconds)."""
        timed = (*self._handles.get("timer", ()), *self._handles.get("event", ()))
        dues = [handle.entity.due_ns for handle in timed]
        return min((due for due in dues if due is not None), default=None)

    def waits_for_same(self, other: WaitSet) -> bool:
        """Return whether both wait sets have the same objects."""
        return self._handles == other._handles

    def remember_waker(self, waker: Callable[[], object]) -> None:
        """Call a quick function whenever one of the objects may be ready."""
        for handles in self._handles.values():
            for handle in handles:
                handle.entity.ready_queue.watch(handle.entity, waker)

    def forget_waker(self, waker: Callable[[], object]) -> None:
        """Stop calling a function that was given to `remember_waker`."""
        for handles in self._handles.values():
            for handle in handles:
                handle.entity.ready_queue.unwatch(handle.entity, waker)
