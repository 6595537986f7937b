"""Waitables: kinds of work that a program defines itself and that an executor runs."""

from __future__ import annotations

from dataclasses import astuple, dataclass
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from zbot.executor.set_by_init import set_by_init
from zbot.executor.wait_set import WaitSet

if TYPE_CHECKING:
    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.ready_queue import ReadyQueue
    from zbot.executor.task import Future

T = TypeVar("T")


@dataclass(repr=False)
class NumberOfEntities:
    """Numbers of the entities that a waitable adds to a wait set. `+` adds two such objects."""

    num_subscriptions: int = 0
    num_guard_conditions: int = 0
    num_timers: int = 0
    num_clients: int = 0
    num_services: int = 0
    num_events: int = 0

    def __add__(self, other: NumberOfEntities) -> NumberOfEntities:
        pairs = zip(astuple(self), astuple(other), strict=True)
        return NumberOfEntities(*(mine + theirs for mine, theirs in pairs))

    def __repr__(self) -> str:
        return f"<{type(self).__name__}{astuple(self)}>"


class Waitable(Generic[T]):
    """Base class of a program's own kind of work. `Node.add_waitable` adds a waitable to a node.

    The executor calls `is_ready` when an object of the wait set may be ready, and when another
    thread wakes the executor. If `is_ready` returns true, the executor calls `take_data` and
    awaits `execute`.

    Args:
        callback_group: Decides which callbacks may run at the same time as `execute`.
    """

    callback_group: CallbackGroup = set_by_init("callback_group")

    def __init__(self, callback_group: CallbackGroup) -> None:
        self.callback_group = callback_group
        callback_group.add_entity(self)
        self._futures: list[Future[Any]] = []

    def __enter__(self) -> None:
        """Do nothing. In rclpy this protects the entities from being destroyed."""

    def __exit__(self, *exc_info: object) -> None:
        """See `__enter__`."""

    def add_future(self, future: Future[Any]) -> None:
        """Keep a future. This does not change which thread runs its done callbacks."""
        self._futures.append(future)

    def remove_future(self, future: Future[Any]) -> None:
        """Remove a future."""
        self._futures.remove(future)

    def is_ready(self, wait_set: WaitSet) -> bool:
        """Return whether `take_data` has data to return."""
        raise NotImplementedError("Must be implemented by subclass")

    def take_data(self) -> T:
        """Return the data for `execute`."""
        raise NotImplementedError("Must be implemented by subclass")

    async def execute(self, taken_data: T) -> None:
        """Do the work."""
        raise NotImplementedError("Must be implemented by subclass")

    def get_num_entities(self) -> NumberOfEntities:
        """Return how many entities of each kind `add_to_wait_set` adds."""
        raise NotImplementedError("Must be implemented by subclass")

    def add_to_wait_set(self, wait_set: WaitSet) -> None:
        """Add the handles of the entities to wait for."""
        raise NotImplementedError("Must be implemented by subclass")


class WaitableEntity:
    """Entity that lets zbot's executors run a waitable.

    Args:
        waitable: The program's waitable.
        ready_queue: The node's ready queue.
    """

    def __init__(self, waitable: Waitable[Any], ready_queue: ReadyQueue) -> None:
        self.waitable = waitable
        self.callback_group = waitable.callback_group
        self.ready_queue = ready_queue
        self._waited_for = WaitSet()
        self._is_destroyed = False

    @property
    def due_ns(self) -> int | None:
        """When the waitable's first timer or event is due (monotonic clock, nanoseconds)."""
        return self._waited_for.due_ns

    def take(self) -> tuple[Any] | None:
        """Return `(data,)`, even if data is `None`. Return `None` if the waitable is not ready."""
        if self._is_destroyed:
            return None
        wait_set = WaitSet()
        self.waitable.add_to_wait_set(wait_set)
        if not self._waited_for.waits_for_same(wait_set):
            self._waited_for.forget_waker(self._post)
            wait_set.remember_waker(self._post)
            self._waited_for = wait_set
        wait_set.wait(0)
        return (self.waitable.take_data(),) if self.waitable.is_ready(wait_set) else None

    def execute(self, taken: tuple[Any]) -> Any:
        """Run the waitable with the data."""
        return self.waitable.execute(taken[0])

    def destroy(self) -> None:
        """Never run the waitable again."""
        self._is_destroyed = True
        self._waited_for.forget_waker(self._post)
        self._waited_for = WaitSet()

    def _post(self) -> None:
        self.ready_queue.post(self)
