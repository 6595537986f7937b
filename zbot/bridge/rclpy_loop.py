"""Loop that waits for data of ROS 2's own rclpy and takes the data, in a thread of its own.

rclpy's executors are several times slower, because they make a Python object of each message.
"""

from __future__ import annotations

import threading
from collections import deque
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

from zbot.threads.deadline import Deadline

if TYPE_CHECKING:
    from collections.abc import Callable

Kind = Literal["subscription", "client", "service"]

# A wait holds the wait set's lock in C, so `close` can only work between two waits.
_LONGEST_WAIT_NS = 250_000_000


@dataclass(frozen=True, eq=False)
class Waiting:
    """Entity whose data the loop takes."""

    kind: Kind
    handle: Any  #: rclpy's handle, which has a `pointer`
    take: Callable[[], None]  #: takes the data that has arrived


class Loop:
    """Wait loop over entities. `add`, `remove` and `call_soon` may be called from any thread.

    Args:
        rclpy_module: ROS 2's own module `rclpy`.
        context: A context of this rclpy.
        tick: Called every `period_s` seconds in the loop's thread.
        period_s: Time between two calls of `tick`, in seconds.
        on_error: Called with the exception that ends the loop.
    """

    def __init__(
        self,
        rclpy_module: Any,
        context: Any,
        tick: Callable[[], None],
        period_s: float,
        on_error: Callable[[Exception], None],
    ) -> None:
        implementation = rclpy_module.impl.implementation_singleton.rclpy_implementation
        self._new_wait_set = implementation.WaitSet
        self._context = context
        self._tick, self._period_s = tick, period_s
        self._on_error = on_error
        self._wake = implementation.GuardCondition(context.handle)
        self._entities: dict[Kind, list[Waiting]] = {
            "subscription": [],
            "client": [],
            "service": [],
        }
        self._calls: deque[Callable[[], None]] = deque()
        self._is_closed = False
        self._thread = threading.Thread(target=self._run, name="zbot bridge rclpy", daemon=True)

    def start(self) -> None:
        """Start the thread."""
        self._thread.start()

    def call_soon(self, function: Callable[[], None]) -> None:
        """Call a function in the loop's thread."""
        self._calls.append(function)
        if not self._is_closed:
            self._wake.trigger_guard_condition()

    def add(self, waiting: Waiting) -> None:
        """Take the data of an entity from now on."""
        self.call_soon(lambda: self._entities[waiting.kind].append(waiting))

    def remove(self, waiting: Waiting, destroy: Callable[[], None]) -> None:
        """Forget an entity, and then destroy it in the loop's thread."""

        def forget() -> None:
            if waiting in self._entities[waiting.kind]:
                self._entities[waiting.kind].remove(waiting)
            destroy()

        self.call_soon(forget)

    def close(self) -> None:
        """End the thread when all functions of `call_soon` were called. Wait for the end."""
        self.call_soon(self._end)
        if self._thread.is_alive():
            self._thread.join()

    def _end(self) -> None:
        self._is_closed = True

    def _run(self) -> None:
        try:
            self._work()
        except Exception as error:  # noqa: BLE001 - the main thread raises it
            self._is_closed = True
            self._on_error(error)

    def _work(self) -> None:
        due, wait_set = Deadline(0), None
        counts: tuple[int, ...] = ()
        while not self._is_closed:
            while self._calls:
                self._calls.popleft()()
            if due.is_over:
                self._tick()
                due = Deadline(self._period_s)
            entities = self._entities
            now = tuple(map(len, entities.values()))
            if wait_set is None or counts != now:
                counts = now
                subscriptions, clients, services = now
                wait_set = self._new_wait_set(
                    subscriptions, 1, 0, clients, services, 0, self._context.handle
                )
            for waiting in self._wait(wait_set, due):
                waiting.take()

    def _wait(self, wait_set: Any, due: Deadline) -> list[Waiting]:
        """Wait until an entity has data or the next tick is due. Return entities with data."""
        entities = self._entities
        wait_set.clear_entities()
        for subscription in entities["subscription"]:
            wait_set.add_subscription(subscription.handle)
        for client in entities["client"]:
            wait_set.add_client(client.handle)
        for service in entities["service"]:
            wait_set.add_service(service.handle)
        wait_set.add_guard_condition(self._wake)
        wait_set.wait(min(int(due.left_s * 1e9), _LONGEST_WAIT_NS))
        found = []
        for kind, all_of_kind in entities.items():
            if all_of_kind:
                ready = set(wait_set.get_ready_entities(kind))
                found += [waiting for waiting in all_of_kind if waiting.handle.pointer in ready]
        return found
