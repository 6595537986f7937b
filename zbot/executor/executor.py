"""Executors: they wait for work of their nodes and run the callbacks.

Nothing is polled. Entities post themselves to their node's ready queue when they may have work (from
any thread); the executor pops them, takes one piece of work at a time in turn, and sleeps on one
lock until the next post or the next timer.
"""

from __future__ import annotations

import contextlib
import threading
import time
from collections import deque
from typing import TYPE_CHECKING, Any

from zbot.errors import ExternalShutdownException, NotInitializedError
from zbot.executor.callback_group import ReentrantCallbackGroup, Refused
from zbot.executor.callback_stack import callbacks
from zbot.executor.errors import ConditionReachedException, ExecutorBusyError, ShutdownError
from zbot.executor.task import Future, Task
from zbot.executor.task_step import TaskStep
from zbot.executor.timer_queue import TimerQueue
from zbot.process import signals
from zbot.time import TimeoutObject
from zbot.transport.wakeup import BinarySemaphore

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Iterator
    from types import TracebackType

    from typing_extensions import Self

    from zbot.context import Context
    from zbot.executor.ready_queue import Entity, ReadyQueue
    from zbot.executor.spinnable import SpinnableNode


def _deadline_ns(timeout_sec: float | None) -> int | None:
    if timeout_sec is None or timeout_sec < 0:
        return None
    return time.monotonic_ns() + int(timeout_sec * 1e9)


class Executor:
    """The base of all executors: nodes, the queue of work, and waiting.

    Args:
        context: Spinning ends when it is shut down; the default context if left out.
    """

    def __init__(self, *, context: Context | None = None) -> None:
        if context is None:
            from zbot.context import get_default_context  # noqa: PLC0415 - it is above us

            context = get_default_context()
        self._context = context
        self._nodes: list[SpinnableNode] = []
        self._ready: deque[Entity] = deque()
        self._queued: set[Entity] = set()
        self._refused = Refused()
        self._agenda = TimerQueue()
        self._signal = BinarySemaphore()
        self._is_shutdown = False
        # Whether somebody wants to be looked at before the same entity's next callback.
        self._is_disturbed = True
        self._due_ns: int | None = None  # when the first timer wants to run
        self._spinning = threading.Lock()
        self._spinner: int | None = None
        context.add_waker(self.wake)

    # -- nodes ---------------------------------------------------------------------------------

    @property
    def is_spinning(self) -> bool:
        """Whether a thread runs callbacks here right now."""
        return self._spinner is not None

    @property
    def is_shutdown(self) -> bool:
        """Whether it was shut down, and takes no node any more."""
        return self._is_shutdown

    @property
    def context(self) -> Context:
        """The context whose shutdown ends spinning."""
        return self._context

    def add_node(self, node: SpinnableNode) -> bool:
        """Take over a node's callbacks; `False` if they are this executor's already."""
        if self._is_shutdown:
            raise ShutdownError("this executor")
        if node in self._nodes:
            return False
        if node.executor is not None:
            node.executor.remove_node(node)
        self._nodes.append(node)
        node.handle.executor = self
        node.handle.ready_queue.attach(self, self._post)
        return True

    def remove_node(self, node: SpinnableNode) -> None:
        """Leave a node's callbacks to others; nothing happens if it is not here."""
        if node in self._nodes:
            self._nodes.remove(node)
            node.handle.ready_queue.detach()
            node.handle.executor = None
            self._forget(node.handle.ready_queue.entities)

    def get_nodes(self) -> list[SpinnableNode]:
        """Return the nodes, in the order they were added."""
        return list(self._nodes)

    def _forget(self, entities: list[Entity]) -> None:
        self._is_disturbed = True
        self._agenda.forget(entities)
        # Other threads post and take meanwhile: turn the queue once, in atomic steps.
        for _ in range(len(self._ready)):
            entity = Executor._pop_ready(self)
            if entity is not None:
                for kept in self._refused.skipped(entity) if entity in entities else [entity]:
                    self._post(kept)

    # -- tasks ---------------------------------------------------------------------------------

    def create_future(self) -> Future[Any]:
        """Return a future whose done callbacks run here."""
        return Future(executor=self)

    def create_task(
        self,
        callback: Callable[..., Any] | Coroutine[Any, Any, Any],
        *args: Any,
        **kwargs: Any,
    ) -> Task[Any]:
        """Run a function or coroutine in this executor; from any thread."""
        task: Task[Any] = Task(callback, args, kwargs, executor=self)
        self.schedule(task)
        return task

    def schedule(self, task: Task[Any]) -> None:
        """Queue a task's next step; from any thread."""
        self._post(TaskStep(task))

    def wake(self) -> None:
        """Let a waiting `spin_once` look for work, and ask all waitables; from any thread."""
        self._is_disturbed = True
        for node in list(self._nodes):
            for waitable in list(node.handle.waitables):
                self._queue(waitable)
        for entity in self._refused.drain():
            self._queue(entity)
        self._signal.set()

    def _post(self, entity: Entity) -> None:
        self._queue(entity)
        self._signal.set()

    def _queue(self, entity: Entity) -> None:
        # Once is enough: it leaves the set before it is asked for work.
        if entity not in self._queued:
            self._queued.add(entity)
            self._ready.append(entity)
            self._is_disturbed = True

    def _pop_ready(self) -> Entity | None:
        try:
            entity = self._ready.popleft()
        except IndexError:
            return None
        self._queued.discard(entity)
        return entity

    def _pop_due_or_ready(self) -> Entity | None:
        due = self._agenda.pop_due(time.monotonic_ns())
        if due is not None:
            self._queue(due)
        return self._pop_ready()

    # -- work ----------------------------------------------------------------------------------

    def _next(
        self, deadline_ns: int | None, stop: Callable[[], bool] | None = None
    ) -> tuple[Entity, Any] | None:
        """Return the next piece of work; `None` at the deadline, on `stop`, or after a shutdown.

        Raises:
            ExternalShutdownException: The context was shut down meanwhile.
        """
        while not (self._is_shutdown or (stop is not None and stop())):
            entity = self._pop_due_or_ready()
            if entity is not None:
                work = self._take(entity)
                if work is not None:
                    return work
                continue
            if not self._context.ok():
                self._tell_shutdown()
                return None
            if not self._sleep(deadline_ns):
                return None
        return None

    def _take(self, entity: Entity) -> tuple[Entity, Any] | None:
        ready_queue = entity.ready_queue
        if ready_queue is not None and ready_queue.executor is not self:
            self._send_on(entity, ready_queue)
            return None
        if not self._refused.begins(entity):
            return None  # it is posted again when the group is free
        taken = entity.take()
        if taken is not None:
            return entity, taken
        for waiting in self._refused.ends(entity):
            self._queue(waiting)
        due = entity.due_ns
        if due is not None:
            self._agenda.put(entity, due)
        return None

    def _send_on(self, entity: Entity, ready_queue: ReadyQueue) -> None:
        ready_queue.post(entity)  # its node is, or went, to another executor
        for waiting in self._refused.skipped(entity):
            self._queue(waiting)

    def _sleep(self, deadline_ns: int | None) -> bool:
        wakes = [due for due in (deadline_ns, self._agenda.earliest_ns()) if due is not None]
        if not wakes:
            self._signal.wait(threading.TIMEOUT_MAX)
            return True
        left = min(wakes) - time.monotonic_ns()
        if left > 0:
            self._signal.wait(left / 1e9)
        return deadline_ns is None or time.monotonic_ns() < deadline_ns

    def can_execute(self, entity: Entity) -> bool:
        """Return whether an entity's callback group would let it run now."""
        return entity.callback_group.can_execute(entity)

    def wait_for_ready_callbacks(
        self,
        timeout_sec: float | TimeoutObject | None = None,
        nodes: list[SpinnableNode] | None = None,  # noqa: ARG002 - rclpy's signature
        condition: Callable[[], bool] | None = None,
    ) -> tuple[Task[None], Entity, SpinnableNode | None]:
        """Wait for one callback, for an executor of a program's own whose `spin_once` runs it.

        Args:
            timeout_sec: Seconds to wait; `None` or below 0 for as long as it takes.
            nodes: Accepted; the nodes of this executor are waited for, and no others.
            condition: Ends the waiting when it is true; asked when something wakes the executor.

        Returns:
            A task that runs the callback when it is called, in any thread; what it is a callback
            of; and the node of that.

        Raises:
            TimeoutError: Nothing came in time.
            ConditionReachedException: The condition is true.
            ShutdownError: This executor was shut down.
            ExternalShutdownException: The context was shut down.
        """
        seconds = timeout_sec.timeout if isinstance(timeout_sec, TimeoutObject) else timeout_sec
        with self._spins():
            work = self._next(_deadline_ns(seconds), condition)
        if work is not None:
            entity = work[0]
            if isinstance(entity.callback_group, ReentrantCallbackGroup):
                self._queue(entity)  # its next piece may run beside this one
            return Task(self._execute_alone, work), entity, self._node_of(entity)
        if self._is_shutdown:
            raise ShutdownError("this executor")
        if condition is not None and condition():
            raise ConditionReachedException
        raise TimeoutError("no callback was ready in time")

    def _wait_for_ready_callbacks(
        self, *args: Any, **kwargs: Any
    ) -> Iterator[tuple[Task[None], Entity, SpinnableNode | None]]:
        # What rclpy's executors make of it, and those of programs that were derived from them.
        while True:
            yield self.wait_for_ready_callbacks(*args, **kwargs)

    def _execute_alone(self, entity: Entity, taken: Any) -> None:
        self._is_disturbed = True  # one callback, and no more
        try:
            self._execute(entity, taken)
        finally:
            self._signal.set()  # it may have been another thread's: the entity may have more

    def _node_of(self, entity: Entity) -> SpinnableNode | None:
        owners = (node for node in self._nodes if node.handle.ready_queue is entity.ready_queue)
        return next(owners, None)

    def _execute(self, entity: Entity, taken: Any) -> None:
        """Run a piece of work and, while nobody else has any, the entity's next ones."""
        outcome = None
        execute, take = entity.execute, entity.take
        callbacks.stack.append((self, entity))
        try:
            # The common case of a busy topic: without a turn of the queue a message costs half.
            while (outcome := execute(taken)) is None and not self._is_disturbed:
                due = self._due_ns
                if due is not None and due <= time.monotonic_ns():
                    break
                taken = take()
                if taken is None:
                    break
        except NotInitializedError as exc:
            if self._context.ok():
                raise
            # The callback used what another thread, or the end of the program, has just closed.
            raise ExternalShutdownException from exc
        finally:
            callbacks.pop()
            if outcome is None or not hasattr(outcome, "send"):
                self._finish(entity)
        if outcome is not None and hasattr(outcome, "send"):
            self._follow(entity, outcome)

    def _follow(self, entity: Entity, coroutine: Coroutine[Any, Any, Any]) -> None:
        """Run an `async def` callback; its group stays taken until it ends."""
        task: Task[Any] = Task(coroutine, executor=self)
        try:
            task()
        finally:
            # What it raises at once must not leave its group taken when nobody spins again.
            if task.is_over:
                self._finish(entity)
            else:
                # Not as a done callback: that would be a piece of work of its own.
                task.add_waker(lambda: self._finish(entity))
                if isinstance(entity.callback_group, ReentrantCallbackGroup):
                    self._queue(entity)  # its next piece may begin while this one waits
        if task.done():
            task.result()

    def serve(self, entity: Entity) -> bool:
        """Run one piece of an entity's work inside the callback that the calling thread is in.

        A callback that waits for a service of its own executor would otherwise wait for itself. A
        group that this thread holds does not keep the entity out: it is as if the callback called
        the other.

        Returns:
            Whether there was any, and the entity's group let it run.
        """
        group = entity.callback_group
        is_held = any(outer.callback_group is group for _, outer in callbacks.stack)
        if not is_held and not self._refused.begins(entity):
            return False
        callbacks.stack.append((self, entity))
        try:
            taken = entity.take()
            if taken is not None:
                outcome = entity.execute(taken)
                if outcome is not None and hasattr(outcome, "send"):
                    self.create_task(outcome)
            return taken is not None
        finally:
            callbacks.pop()
            for waiting in () if is_held else self._refused.ends(entity):
                self._queue(waiting)

    def _serve_next(self, deadline_ns: int | None, stop: Callable[[], bool] | None) -> None:
        """Run one piece of work inside the callback that the spinning thread is in."""
        while not (self._is_shutdown or (stop is not None and stop())):
            entity = self._pop_due_or_ready()
            if entity is not None:
                if self._serve_in_turn(entity):
                    return
            elif not self._context.ok():
                self._tell_shutdown()
                return
            elif not self._sleep(deadline_ns):
                return

    def _serve_in_turn(self, entity: Entity) -> bool:
        ready_queue = entity.ready_queue
        if ready_queue is not None and ready_queue.executor is not self:
            self._send_on(entity, ready_queue)
            return False
        if any(outer is entity for _, outer in callbacks.stack):
            return False  # a callback never begins inside itself; it is asked again at its end
        if self.serve(entity):
            self._queue(entity)  # it may have more
            return True
        due = entity.due_ns
        if due is not None:
            self._agenda.put(entity, due)
        return False

    def _finish(self, entity: Entity) -> None:
        # In front: they had their turn already, and were sent away.
        for waiting in reversed(self._refused.ends(entity)):
            if waiting not in self._queued:
                self._queued.add(waiting)
                self._ready.appendleft(waiting)
                self._is_disturbed = True
        self._queue(entity)  # it may have more

    # -- spinning ------------------------------------------------------------------------------

    def spin(self) -> None:
        """Run callbacks until the context or this executor is shut down.

        An exception of a callback ends it and comes out here, as in rclpy.

        Raises:
            ExternalShutdownException: The context was shut down while no callback was running.
        """
        while self._context.ok() and not self._is_shutdown:
            self.spin_once()
        self._tell_interruption()

    def _tell_shutdown(self) -> None:
        # Whoever shuts both down begins with the executor: that is a quiet end.
        if not self._is_shutdown:
            raise ExternalShutdownException

    def _tell_interruption(self) -> None:
        # The handler's own exception may have been caught on its way, by a callback say.
        if self._context.is_interrupted:
            raise ExternalShutdownException

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Run one callback, waiting for it at most `timeout_sec` seconds (`None`: for ever).

        A callback may spin the executor that runs it: others run inside it then, those of its own
        callback group too, but never itself.

        Raises:
            ExecutorBusyError: Another thread spins this executor.
        """
        self._spin_once(_deadline_ns(timeout_sec))

    def spin_until_future_complete(
        self, future: Future[Any], timeout_sec: float | None = None
    ) -> None:
        """Run callbacks until the future is done, at most `timeout_sec` seconds.

        Where another thread spins this executor already, this one only waits for the future.
        """
        deadline = _deadline_ns(timeout_sec)
        if self._is_spun_elsewhere():
            self._wait_beside(future, deadline)
            return
        future.add_waker(self._signal.set)
        while not future.is_over and self._context.ok() and not self._is_shutdown:
            self._spin_once(deadline, lambda: future.is_over)
            if deadline is not None and time.monotonic_ns() >= deadline:
                return

    def spin_once_until_future_complete(
        self, future: Future[Any], timeout_sec: float | None = None
    ) -> None:
        """Run one callback, or return earlier when the future is done."""
        if self._is_spun_elsewhere():
            self._wait_beside(future, _deadline_ns(timeout_sec))
            return
        future.add_waker(self._signal.set)
        self._spin_once(_deadline_ns(timeout_sec), lambda: future.is_over)

    def _spin_once(self, deadline_ns: int | None, stop: Callable[[], bool] | None = None) -> None:
        raise NotImplementedError

    def _is_spun_elsewhere(self) -> bool:
        return self._spinner not in (None, threading.get_ident())

    def _wait_beside(self, future: Future[Any], deadline_ns: int | None) -> None:
        """Wait for a future while another thread runs the callbacks."""
        wake = BinarySemaphore()
        future.add_waker(wake.set)
        self._context.add_waker(wake.set)
        try:
            while not future.is_over and self._context.ok() and not self._is_shutdown:
                if deadline_ns is None:
                    wake.wait(threading.TIMEOUT_MAX)
                elif (left := deadline_ns - time.monotonic_ns()) > 0:
                    wake.wait(left / 1e9)
                else:
                    return
        finally:
            self._context.remove_waker(wake.set)

    @contextlib.contextmanager
    def _spins(self) -> Iterator[None]:
        if not self._spinning.acquire(blocking=False):
            if self._spinner is not None:
                raise ExecutorBusyError
            self._spinning.acquire()  # `wait_idle` holds it for a moment
        in_main = threading.current_thread() is threading.main_thread()
        signals.MainThread.spins += in_main
        self._spinner = threading.get_ident()
        try:
            yield
        finally:
            self._spinner = None
            signals.MainThread.spins -= in_main
            self._spinning.release()

    # -- end -----------------------------------------------------------------------------------

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        """Stop spinning, leave all nodes, and wait for running callbacks; may be called twice.

        Returns:
            Whether the callbacks ended within `timeout_sec` seconds (`None`: waited for ever).
        """
        self._is_shutdown = True
        self.wake()
        ended = self.wait_idle(-1 if timeout_sec is None or timeout_sec < 0 else timeout_sec)
        for node in list(self._nodes):
            self.remove_node(node)
        self._context.remove_waker(self.wake)
        return ended

    def wait_idle(self, timeout_s: float) -> bool:
        """Wait until nothing spins here, other than the caller; below 0 for as long as it takes."""
        if self._spinner == threading.get_ident():
            return True  # a callback shuts down its own executor
        ended = self._spinning.acquire(timeout=timeout_s)
        if ended:
            self._spinning.release()
        return ended

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc_val: BaseException | None,
        exc_tb: TracebackType | None,
    ) -> None:
        self.shutdown()


class SingleThreadedExecutor(Executor):
    """Runs every callback in the thread that spins."""

    def spin(self) -> None:
        """Run callbacks until the context or this executor is shut down.

        Raises:
            ExternalShutdownException: The context was shut down while no callback was running.
        """
        with self._spins():
            while self._context.ok() and not self._is_shutdown:
                self._is_disturbed = False
                work = self._next(None)
                if work is not None:
                    self._due_ns = self._agenda.earliest_ns()
                    self._is_disturbed = self._is_disturbed or bool(self._ready)
                    self._execute(*work)
        self._tell_interruption()

    def _spin_once(self, deadline_ns: int | None, stop: Callable[[], bool] | None = None) -> None:
        if self._spinner == threading.get_ident():
            self._serve_next(deadline_ns, stop)
            return
        with self._spins():
            work = self._next(deadline_ns, stop)
            self._is_disturbed = True  # one callback, and no more
            if work is not None:
                self._execute(*work)
