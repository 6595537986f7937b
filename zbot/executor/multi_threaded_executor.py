"""Executor that runs callbacks in several threads at the same time."""

from __future__ import annotations

import contextlib
import os
import sys
import threading
import warnings
from collections import deque
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

from zbot.errors import ArgumentTypeError, ExternalShutdownException
from zbot.executor.callback_group import ReentrantCallbackGroup
from zbot.executor.executor import Executor, restores_executor

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.context import Context
    from zbot.executor.ready_queue import Entity


def _core_count() -> int:
    # A container or `taskset` may give the process fewer cores than the machine has.
    if sys.platform == "linux":  # other systems have no such call
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


class Job:
    """Work that a thread of the pool does. It is done once, also if the pool gets it twice."""

    __slots__ = ("_begun", "entity", "taken")

    def __init__(self, entity: Entity, taken: Any) -> None:
        self.entity = entity
        self.taken = taken
        self._begun = threading.Lock()

    def begin(self) -> bool:
        """Return whether the work has not begun before. It counts as begun after this."""
        return self._begun.acquire(blocking=False)


class MultiThreadedExecutor(Executor):
    """Runs callbacks in a pool of threads, as their callback groups allow.

    Args:
        num_threads: Size of the pool. The default is the number of processor cores, but at least
            2. With 1 there is a `UserWarning`.
        context: See `Executor`.
    """

    def __init__(self, num_threads: int | None = None, *, context: Context | None = None) -> None:
        if num_threads is not None and not hasattr(num_threads, "__float__"):
            expected = "a number; add nodes with executor.add_node(node)"
            raise ArgumentTypeError("num_threads", expected, num_threads)
        super().__init__(context=context)
        self._num_threads = max(1, num_threads or max(2, _core_count()))
        if self._num_threads == 1:
            limit = "a MultiThreadedExecutor with one thread runs one callback at a time"
            warnings.warn(f"{limit}; use a SingleThreadedExecutor, or more threads", stacklevel=2)
        # This is rclpy's name, because programs read the number of threads from this attribute.
        self._executor = ThreadPoolExecutor(self._num_threads, thread_name_prefix="zbot executor")
        self._failures: deque[BaseException] = deque()
        self._idle = threading.Condition()
        self._jobs: set[Job] = set()  # the pool runs them, or will run them
        self._workers: set[int] = set()  # threads that are inside a callback

    @restores_executor
    def spin(self) -> None:
        """Run callbacks until the context or this executor is shut down.

        Raises:
            ExternalShutdownException: A signal came, or a callback used the context after shutdown.
        """
        if self._has_own("spin_once"):
            super().spin()  # it calls the program's method
            return
        self._begin_spin()
        try:
            while self._context.is_running and not self._is_shutdown:
                self._run_next(None, None)
        finally:
            self._end_spin()
        self._raise_interruption()

    @restores_executor
    def _spin_once(self, deadline_ns: int | None, stop: Callable[[], bool] | None = None) -> None:
        if threading.get_ident() in self._workers:
            self._wait_for_turn(deadline_ns)
            return
        if not self._begin_turn(deadline_ns):
            return
        try:
            self._run_next(deadline_ns, stop)
        finally:
            self._end_spin()

    def _run_next(self, deadline_ns: int | None, stop: Callable[[], bool] | None) -> None:
        # As in rclpy, spin() returns without this error if another thread shuts down the context.
        with contextlib.suppress(ExternalShutdownException):
            work = self._next_work(deadline_ns, lambda: self._must_stop(stop))
            if work is not None:
                self._submit(*work)
        if self._failures:
            raise self._failures.popleft()

    def _is_spun_by_other_thread(self) -> bool:
        # A callback must not spin this executor. This is also true if no thread spins the executor
        # at the moment, e.g. between two calls of `spin_once`.
        return super()._is_spun_by_other_thread() or threading.get_ident() in self._workers

    @property
    def runs_callbacks(self) -> bool:
        """Whether a callback runs in another thread."""
        return bool(self._jobs)

    def _must_stop(self, stop: Callable[[], bool] | None) -> bool:
        return bool(self._failures) or (stop is not None and stop())

    def _pop_ready(self) -> Entity | None:
        # While all threads are busy, work stays in the entity's own queue of limited length.
        return None if len(self._jobs) >= self._num_threads else super()._pop_ready()

    def _submit(self, entity: Entity, taken: Any) -> None:
        if isinstance(entity.callback_group, ReentrantCallbackGroup):
            self._queue(entity)  # its next work may run at the same time
        job = Job(entity, taken)
        self._current = None
        self._jobs.add(job)
        self._give_to_pool(job)

    def _give_to_pool(self, job: Job) -> None:
        try:
            self._executor.submit(self._run_in_pool, job)
        except RuntimeError:
            # Another thread called shutdown(), or the program ends.
            self._is_shutdown = True
            if job.begin():
                self._end_job(job)
                self._finish(job.entity)

    def _run_in_pool(self, job: Job) -> None:
        if not job.begin():
            return
        me = threading.get_ident()
        self._workers.add(me)
        try:
            self._execute(job.entity, job.taken)
        except BaseException as exc:  # noqa: BLE001 - raised again by the spinning thread
            self._failures.append(exc)
        finally:
            self._workers.discard(me)
            self._end_job(job)

    def _end_job(self, job: Job) -> None:
        with self._idle:
            self._jobs.discard(job)
            self._idle.notify_all()
        self._wakeup.set()

    def _restore(self) -> None:
        super()._restore()
        for job in list(self._jobs):
            self._give_to_pool(job)  # it is not known whether the pool has it

    def wait_idle(self, timeout_s: float) -> bool:
        """Wait until no other thread spins this executor and no other callback runs."""
        own = threading.get_ident() in self._workers
        with self._idle:
            ended = self._idle.wait_for(
                lambda: len(self._jobs) <= own, None if timeout_s < 0 else timeout_s
            )
        return ended and super().wait_idle(timeout_s)

    def shutdown(self, timeout_sec: float | None = None, *, wait_for_threads: bool = True) -> bool:
        """Stop spinning, wait for running callbacks, remove all nodes, and end the threads."""
        ended = super().shutdown(timeout_sec)
        if self._context.is_inherited:
            return ended  # the threads are the parent's
        own = threading.get_ident() in self._workers
        self._executor.shutdown(wait=wait_for_threads and ended and not own)
        return ended
