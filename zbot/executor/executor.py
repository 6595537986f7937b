"""Executor that waits for work of its nodes and runs their callbacks.

The executor does not poll. An entity posts itself to its node's ready queue when it may have work.
Any thread may post. The executor removes one entity after the other from its queue, and takes one
piece of work from each. Without work, the executor waits for one lock until an entity is posted or
a timer is due.
"""

from __future__ import annotations

import contextlib
import functools
import threading
import time
import weakref
from typing import TYPE_CHECKING, Any, TypeVar, cast

from zbot.errors import NotInitializedError, WrongStateError
from zbot.executor.callback_group import ReentrantCallbackGroup
from zbot.executor.callback_stack import running_callbacks
from zbot.executor.errors import ConditionReachedException, ShutdownError
from zbot.executor.executor_nodes import ExecutorNodes
from zbot.executor.forgotten_spin import Program, warn_of_target
from zbot.executor.set_by_init import set_by_init
from zbot.executor.spin_arguments import check_future, deadline_ns_of, left_s
from zbot.executor.task import Future, Task, TaskStep
from zbot.process import signals
from zbot.threads.wakeup import BinarySemaphore, waking
from zbot.time import TimeoutObject

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Iterator

    from typing_extensions import Self

    from zbot.context import Context
    from zbot.executor.ready_queue import Entity
    from zbot.executor.spinnable import SpinnableNode


# A thread that begins to spin takes the lock a moment before it becomes the spinning thread, and
# `wait_idle` holds the lock only for a moment.
_LOCK_TIMEOUT_S = 0.001
#: A program's own executor looks at the future this often.
_LOOK_S = 0.05

MethodT = TypeVar("MethodT", bound="Callable[..., Any]")


def restores_executor(method: MethodT) -> MethodT:
    """Let an executor spin again after an exception of a signal, which may come at any line.

    A program may catch the exception and go on, e.g. to cancel a goal.
    """

    @functools.wraps(method)
    def spin(self: Executor, *args: Any, **kwargs: Any) -> Any:
        is_inner = self._spinning_thread == threading.get_ident()
        try:
            return method(self, *args, **kwargs)
        except BaseException as error:
            if not (is_inner or isinstance(error, Exception)):
                self._restore()
            raise

    return cast("MethodT", spin)


class Executor(ExecutorNodes):
    """Base class of all executors. It runs the callbacks of its nodes, and waits for work.

    Args:
        context: Spinning ends when this context is shut down. If left out, the default context is
            used.
    """

    _spinning_thread: int | None = set_by_init()
    _spin_lock: threading.RLock = set_by_init()

    def __init__(self, *, context: Context | None = None) -> None:
        if context is None:
            from zbot.context import get_default_context  # noqa: PLC0415 - not before it is needed

            context = get_default_context()
        super().__init__(context)
        self._due_ns: int | None = None  # when the first timer is due
        # A signal's exception may come when the lock is just acquired. The lock is re-entrant, so
        # that the same thread can spin again.
        self._spin_lock = threading.RLock()
        self._spinning_thread = None
        # The context keeps only the semaphore: a program may drop an executor without `shutdown`.
        context.add_waker(self._wakeup.set)
        weakref.finalize(self, context.remove_waker, self._wakeup.set).atexit = False

    @property
    def is_spinning(self) -> bool:
        """Whether a thread spins this executor now."""
        return self._spinning_thread is not None

    def create_future(self) -> Future[Any]:
        """Return a future whose done callbacks run in this executor."""
        return Future(executor=self)

    def create_task(
        self,
        callback: Callable[..., Any] | Coroutine[Any, Any, Any],
        *args: Any,
        **kwargs: Any,
    ) -> Task[Any]:
        """Run a function or coroutine in this executor. Any thread may call this."""
        task: Task[Any] = Task(callback, args, kwargs, executor=self)
        self.schedule(task)
        return task

    def schedule(self, task: Task[Any]) -> None:
        """Queue a task's next step. Any thread may call this."""
        self._post(TaskStep(task))

    def wake(self) -> None:
        """Wake a waiting `spin_once`, and ask all waitables for work. Any thread may call this."""
        self._must_requeue = True
        for node in list(self._nodes):
            for waitable in list(node.handle.waitables):
                self._queue(waitable)
        for entity in self._groups.drain():
            self._queue(entity)
        self._wakeup.set()

    @property
    def runs_callbacks(self) -> bool:
        """Whether a callback runs in another thread."""
        return False

    def has_more_work(self) -> bool:
        """Queue all entities that have work, and return whether any entity is queued.

        In contrast to the queue, this also finds messages that have arrived, but whose subscription
        does not know it yet. Only the thread that spins may call it, e.g. in an entity's `take`.
        """
        running = [entity for _, entity in running_callbacks.stack]
        for entity in self._entities():
            # A program's own waitable does not say whether it has work.
            has_work = getattr(entity, "has_work", False)
            if has_work and entity not in running and self.can_execute(entity):
                self._queue(entity)
        return bool(self._ready)

    def _next_work(
        self, deadline_ns: int | None, stop: Callable[[], bool] | None = None
    ) -> tuple[Entity, Any] | None:
        """Return the next piece of work.

        Return `None` at the deadline, when `stop` returns true, or if this executor is shut down.

        Raises:
            ExternalShutdownException: The context was shut down during the wait.
        """
        while not (self._is_shutdown or (stop is not None and stop())):
            entity = self._pop_due_or_ready()
            if entity is not None:
                work = self._take_work(entity)
                if work is not None:
                    return work
                continue
            if not self._context.is_running:
                self._raise_shutdown()
                return None
            if not self._sleep(deadline_ns):
                return None
        return None

    def can_execute(self, entity: Entity) -> bool:
        """Return whether an entity's callback group allows its callback to begin now."""
        return entity.callback_group.can_execute(entity)

    @restores_executor
    def wait_for_ready_callbacks(
        self,
        timeout_sec: float | TimeoutObject | None = None,
        nodes: list[SpinnableNode] | None = None,  # noqa: ARG002 - rclpy's signature
        condition: Callable[[], bool] | None = None,
    ) -> tuple[Task[None], Entity, SpinnableNode | None]:
        """Return one ready callback. The `spin_once` of a program's own executor can call this.

        Args:
            timeout_sec: Seconds to wait. With `None` or a number below 0 there is no limit.
            nodes: Accepted and not used. The executor waits for all its nodes.
            condition: The wait ends when this function returns true. The function is called after
                each wake-up.

        Returns:
            Three objects: a task, the entity of the callback, and the node of the entity. A call of
            the task runs the callback. Any thread may call the task.

        Raises:
            TimeoutError: No callback was ready in time.
            ConditionReachedException: The condition is true.
            ShutdownError: This executor was shut down.
            ExternalShutdownException: The context was shut down.
        """
        seconds = timeout_sec.timeout if isinstance(timeout_sec, TimeoutObject) else timeout_sec
        self._begin_spin()
        try:
            work = self._next_work(deadline_ns_of(seconds), condition)
        finally:
            self._end_spin()
        if work is not None:
            entity = work[0]
            if isinstance(entity.callback_group, ReentrantCallbackGroup):
                self._queue(entity)  # its next work may run in parallel with this work
            self._current = None
            return Task(self._execute_one, work), entity, self._node_of(entity)
        if self._is_shutdown:
            raise ShutdownError("this executor")
        if condition is not None and condition():
            raise ConditionReachedException
        raise TimeoutError("no callback was ready in time")

    def _wait_for_ready_callbacks(
        self, *args: Any, **kwargs: Any
    ) -> Iterator[tuple[Task[None], Entity, SpinnableNode | None]]:
        # This is a private name of rclpy, which a program's own executor may call.
        while True:
            yield self.wait_for_ready_callbacks(*args, **kwargs)

    def _execute_one(self, entity: Entity, taken: Any) -> None:
        self._must_requeue = True  # run one callback only
        try:
            self._execute(entity, taken)
        finally:
            self._wakeup.set()  # for the thread that spins: the entity may have more work

    def _execute(self, entity: Entity, taken: Any) -> None:
        """Run a piece of work. Then run more work of this entity while no other entity has work."""
        outcome = None
        execute, take = entity.execute, entity.take
        running_callbacks.stack.append((self, entity))
        try:
            # This loop makes busy topics faster: a message takes half the time without the queue.
            while (outcome := execute(taken)) is None and not self._must_requeue:
                due = self._due_ns
                if due is not None and due <= time.monotonic_ns():
                    break
                taken = take()
                if taken is None:
                    break
        except NotInitializedError:
            if self._context.is_running:
                raise
            # The callback used something that another thread or the program's end has just closed.
            signals.raise_shutdown(by_signal=self._context.is_interrupted)
        finally:
            running_callbacks.pop()
            if outcome is None or not hasattr(outcome, "send"):
                self._finish(entity)
        if outcome is not None and hasattr(outcome, "send"):
            self._run_coroutine(entity, outcome)

    def _run_coroutine(self, entity: Entity, coroutine: Coroutine[Any, Any, Any]) -> None:
        """Run an `async def` callback. Its group stays reserved until the callback ends."""
        task: Task[Any] = Task(coroutine, executor=self)
        try:
            task()
        finally:
            # Release the group here, also after an exception: perhaps no thread will spin again.
            if task.is_over:
                self._finish(entity)
            else:
                # The function is added as a waker. A done callback would first wait in the queue.
                task.add_waker(lambda: self._finish(entity))
                if isinstance(entity.callback_group, ReentrantCallbackGroup):
                    self._queue(entity)  # its next work may begin while this coroutine waits
        if task.done():
            task.result()

    def serve(self, entity: Entity) -> bool:
        """Run one piece of an entity's work inside the calling thread's present callback.

        Without this, a callback that waits for a service of its own executor would block for ever.
        The entity may run even if the calling thread holds the entity's callback group, because
        this is like a direct call from one callback to the other.

        Returns:
            Whether the entity had work and its callback group allowed it.
        """
        group = entity.callback_group
        is_held = any(outer.callback_group is group for _, outer in running_callbacks.stack)
        if not is_held and not self._groups.reserve(entity):
            return False
        running_callbacks.stack.append((self, entity))
        try:
            taken = entity.take()
            if taken is not None:
                outcome = entity.execute(taken)
                if outcome is not None and hasattr(outcome, "send"):
                    self.create_task(outcome)
            return taken is not None
        finally:
            for waiting in () if is_held else self._groups.release(entity):
                self._queue(waiting)
            running_callbacks.pop()

    def _serve_next(self, deadline_ns: int | None, stop: Callable[[], bool] | None) -> None:
        """Run one piece of work inside the spinning thread's present callback."""
        while not (self._is_shutdown or (stop is not None and stop())):
            entity = self._pop_due_or_ready()
            if entity is not None:
                if self._serve_entity(entity):
                    return
            elif not self._context.is_running:
                self._raise_shutdown()
                return
            elif not self._sleep(deadline_ns):
                return

    def _serve_entity(self, entity: Entity) -> bool:
        ready_queue = entity.ready_queue
        if ready_queue is not None and ready_queue.executor is not self:
            self._forward(entity, ready_queue)
            return False
        if any(outer is entity for _, outer in running_callbacks.stack):
            return False  # a callback never runs inside itself, and its end queues the entity again
        if self.serve(entity):
            self._queue(entity)  # it may have more work
            return True
        due = entity.due_ns
        if due is not None:
            self._timers.put(entity, due)
        return False

    def spin(self) -> None:
        """Run callbacks until the context or this executor is shut down.

        If a callback raises an exception, `spin` ends and raises this exception, as in rclpy.

        Raises:
            ExternalShutdownException: A signal came, or the context was shut down during a wait.
        """
        self._require_ready()
        warn_of_target()
        while self._context.is_running and not self._is_shutdown:
            self.spin_once()
        self._raise_interruption()

    def _raise_shutdown(self) -> None:
        # If a program shuts down the executor and then the context, `spin` raises no error.
        if not self._is_shutdown:
            signals.raise_shutdown(by_signal=self._context.is_interrupted)

    def _raise_interruption(self) -> None:
        self._require_ready()
        # Other code, such as a callback, may have caught the signal handler's exception.
        if self._context.is_interrupted:
            signals.raise_shutdown(by_signal=True)

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Wait for one callback, at most `timeout_sec` seconds (`None`: no limit), and run it.

        A callback may spin the executor that runs it. Other callbacks then run inside the callback,
        also callbacks of the same group. A callback never runs inside itself. If another thread
        spins the executor, the call waits until that thread has run a callback.

        Raises:
            ExternalShutdownException: A signal came, or the context was shut down during a wait.
        """
        self._require_ready()
        self._spin_once(deadline_ns_of(timeout_sec))

    def spin_until_future_complete(
        self, future: Future[Any], timeout_sec: float | None = None
    ) -> None:
        """Run callbacks until the future is done or cancelled, at most `timeout_sec` seconds.

        If another thread spins this executor, the calling thread only waits for the future.
        """
        check_future(future)
        deadline = deadline_ns_of(timeout_sec)
        if self._is_spun_by_other_thread():
            self._wait_for_future(future, deadline)
            return
        with waking(self._wakeup.set, future):
            while not future.is_over and self._context.is_running and not self._is_shutdown:
                self._spin_for(future, deadline)
                if deadline is not None and time.monotonic_ns() >= deadline:
                    return

    def spin_once_until_future_complete(
        self, future: Future[Any], timeout_sec: float | None = None
    ) -> None:
        """Run the next callback. If the future is over or the time has passed, run no callback."""
        check_future(future)
        if self._is_spun_by_other_thread():
            self._wait_for_future(future, deadline_ns_of(timeout_sec))
            return
        with waking(self._wakeup.set, future):
            self._spin_once(deadline_ns_of(timeout_sec), lambda: future.is_over)

    def _spin_once(self, deadline_ns: int | None, stop: Callable[[], bool] | None = None) -> None:
        """Run one callback with the `spin_once` of a program's own executor."""
        if not self._has_own("spin_once"):
            raise NotImplementedError(f"{type(self).__name__} needs the method spin_once")
        left = left_s(deadline_ns)
        if stop is not None:
            left = _LOOK_S if left is None else min(left, _LOOK_S)
        self.spin_once(left)

    def _has_own(self, method: str) -> bool:
        """Return whether a program's own class replaces a method of `Executor`."""
        return getattr(type(self), method) is not getattr(Executor, method)

    def _spin_for(self, future: Future[Any], deadline_ns: int | None) -> None:
        if self._has_own("spin_once_until_future_complete"):
            self.spin_once_until_future_complete(future, left_s(deadline_ns))
        else:
            self._spin_once(deadline_ns, lambda: future.is_over)

    def _is_spun_by_other_thread(self) -> bool:
        self._require_ready()
        return self._spinning_thread not in (None, threading.get_ident())

    def _wait_for_future(self, future: Future[Any], deadline_ns: int | None) -> None:
        """Wait for a future while another thread runs the callbacks."""
        wake = BinarySemaphore()
        with waking(wake.set, future, self._context):
            while not future.is_over and self._context.is_running and not self._is_shutdown:
                if deadline_ns is None:
                    wake.wait(threading.TIMEOUT_MAX)
                elif (left := deadline_ns - time.monotonic_ns()) > 0:
                    wake.wait(left / 1e9)
                else:
                    return

    def _begin_spin(self) -> None:
        """Begin to spin.

        Raises:
            WrongStateError: This executor is already spinning.
        """
        warn_of_target()
        if not self._try_to_spin():
            raise WrongStateError(
                "this executor is already spinning: another thread, or the callback that calls "
                "this, runs in its spin(); use one executor for each thread, and `await` in a "
                "callback"
            )

    def _begin_turn(self, deadline_ns: int | None) -> bool:
        """Begin to spin. If another thread spins, wait for its next callback and return `False`."""
        while not self._try_to_spin():
            if self._wait_for_turn(deadline_ns, may_spin=True):
                return False
        return True

    def _wait_for_turn(self, deadline_ns: int | None, *, may_spin: bool = False) -> bool:
        """Wait until another thread has run a callback or stops spinning.

        Args:
            deadline_ns: When the wait ends.
            may_spin: Whether not to wait if the other thread has stopped spinning already.

        Returns:
            `False` if the other thread stopped spinning and the wait has to go on.
        """
        turn: Future[None] = Future()
        self._turns.append(turn)
        if may_spin and self._spinning_thread is None:
            turn.cancel()  # the other thread may have stopped before it could see the turn
        self._must_requeue = True  # the running entity's callbacks end after the present one
        self._wait_for_future(turn, deadline_ns)
        with contextlib.suppress(ValueError):
            self._turns.remove(turn)
        if not self._context.is_running:
            self._raise_shutdown()
        return not turn.cancelled()

    def _try_to_spin(self) -> bool:
        self._require_ready()
        me = threading.get_ident()
        if self._spinning_thread == me:
            return False
        while not self._spin_lock.acquire(timeout=_LOCK_TIMEOUT_S):
            if self._spinning_thread is not None:
                return False
        Program.has_spun = True
        self._spinning_thread = me
        if me == threading.main_thread().ident:
            signals.MainThread.spinning.add(self)
        if self._paused is not None:
            self._drop_paused()
        return True

    def _end_spin(self) -> None:
        self._spinning_thread = None
        for turn in self._pop_turns():
            turn.cancel()
        signals.MainThread.spinning.discard(self)
        self._spin_lock.release()

    def _restore(self) -> None:
        """End a spin of this thread that a signal's exception has left half ended.

        All entities are queued: the exception may have come when one was just removed.
        """
        for entity in running_callbacks.forget(self):
            self._groups.abandon(entity)
        if self._spin_lock.acquire(blocking=False):  # no other thread spins
            self._abandon_current()
            self._end_spin()
            with contextlib.suppress(RuntimeError):  # this thread does not hold the lock any more
                while True:
                    self._spin_lock.release()
        self._requeue(self._entities())

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        """Stop spinning, wait for running callbacks, and remove all nodes.

        This method may be called twice.

        Returns:
            Whether the callbacks ended within `timeout_sec` seconds (`None`: no limit).
        """
        self._is_shutdown = True
        if self.context.is_inherited:
            return True  # the threads and the nodes are the parent's
        self.wake()
        ended = self.wait_idle(-1 if timeout_sec is None or timeout_sec < 0 else timeout_sec)
        for node in list(self._nodes):
            self.remove_node(node)
        self._drop_paused()
        self._context.remove_waker(self._wakeup.set)
        return ended

    def wait_idle(self, timeout_s: float) -> bool:
        """Wait until no other thread spins this executor. A timeout below 0 means no limit."""
        if self._spinning_thread == threading.get_ident():
            return True  # a callback shuts down its own executor
        ended = self._spin_lock.acquire(timeout=timeout_s)
        if ended:
            self._spin_lock.release()
        return ended

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exc_info: object) -> None:
        self.shutdown()
