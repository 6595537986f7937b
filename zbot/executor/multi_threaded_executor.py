"""The executor that runs callbacks beside each other."""

from __future__ import annotations

import contextlib
import os
import threading
import time
import warnings
from collections import deque
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

from zbot.errors import ExternalShutdownException
from zbot.executor.callback_group import ReentrantCallbackGroup
from zbot.executor.executor import Executor

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.context import Context
    from zbot.executor.ready_queue import Entity


def _core_count() -> int:
    # A container or `taskset` may leave the process fewer cores than the machine has.
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


class MultiThreadedExecutor(Executor):
    """Runs callbacks in a pool of threads, as far as their callback groups allow.

    Args:
        num_threads: Size of the pool; by default one per processor core, but at least 2. A pool of
            one draws a `UserWarning`.
        context: See `Executor`.
    """

    def __init__(self, num_threads: int | None = None, *, context: Context | None = None) -> None:
        super().__init__(context=context)
        self._num_threads = max(1, num_threads or max(2, _core_count()))
        if self._num_threads == 1:
            one = "a MultiThreadedExecutor of one thread runs no callbacks beside each other"
            warnings.warn(f"{one}; use a SingleThreadedExecutor, or more threads", stacklevel=2)
        # rclpy's name: programs look into it for the number of threads.
        self._executor = ThreadPoolExecutor(self._num_threads, thread_name_prefix="zbot executor")
        self._failures: deque[BaseException] = deque()
        self._idle = threading.Condition()
        self._running = 0
        self._workers: set[int] = set()  # threads that are inside a callback

    def spin(self) -> None:
        """Run callbacks until the context or this executor is shut down.

        Raises:
            ExternalShutdownException: Ctrl-C came while no callback was running.
        """
        with self._spins():
            while self._context.ok() and not self._is_shutdown:
                self._turn(None, None)
        self._tell_interruption()

    def _spin_once(self, deadline_ns: int | None, stop: Callable[[], bool] | None = None) -> None:
        if threading.get_ident() in self._workers:
            self._wait_for_another(deadline_ns)
            return
        with self._spins():
            self._turn(deadline_ns, stop)

    def _turn(self, deadline_ns: int | None, stop: Callable[[], bool] | None) -> None:
        # As in rclpy, a shutdown from outside lets this executor's spin() return.
        with contextlib.suppress(ExternalShutdownException):
            work = self._next(deadline_ns, lambda: self._may_stop(stop))
            if work is not None:
                self._hand_over(*work)
        if self._failures:
            raise self._failures.popleft()

    def _wait_for_another(self, deadline_ns: int | None) -> None:
        """Wait, inside a callback, until another one ends: the spinning thread begins them."""
        left = None if deadline_ns is None else (deadline_ns - time.monotonic_ns()) / 1e9
        with self._idle:
            self._idle.wait(left)

    def _is_spun_elsewhere(self) -> bool:
        # Between two callbacks nobody spins for a moment, and a callback must not take over.
        return threading.get_ident() in self._workers or super()._is_spun_elsewhere()

    def _may_stop(self, stop: Callable[[], bool] | None) -> bool:
        return bool(self._failures) or (stop is not None and stop())

    def _pop_ready(self) -> Entity | None:
        # Work that waits in the pool would be taken out of its bounded queue: leave it there.
        return None if self._running >= self._num_threads else super()._pop_ready()

    def _hand_over(self, entity: Entity, taken: Any) -> None:
        with self._idle:
            self._running += 1
        if isinstance(entity.callback_group, ReentrantCallbackGroup):
            self._queue(entity)  # its next piece may run beside this one
        try:
            self._executor.submit(self._work, entity, taken)
        except RuntimeError:
            # shutdown() came between, or the program is at its end.
            self._is_shutdown = True
            self._end_work()
            self._finish(entity)

    def _work(self, entity: Entity, taken: Any) -> None:
        me = threading.get_ident()
        self._workers.add(me)
        try:
            self._execute(entity, taken)
        except BaseException as exc:  # noqa: BLE001 - raised again by the spinning thread
            self._failures.append(exc)
        finally:
            self._workers.discard(me)
            self._end_work()

    def _end_work(self) -> None:
        with self._idle:
            self._running -= 1
            self._idle.notify_all()
        self._signal.set()

    def wait_idle(self, timeout_s: float) -> bool:
        """Wait until nothing spins here and no callback runs, other than the caller's own."""
        own = threading.get_ident() in self._workers
        with self._idle:
            ended = self._idle.wait_for(
                lambda: self._running <= own, None if timeout_s < 0 else timeout_s
            )
        return ended and super().wait_idle(timeout_s)

    def shutdown(self, timeout_sec: float | None = None, *, wait_for_threads: bool = True) -> bool:
        """Stop spinning, leave all nodes, wait for running callbacks, and end the threads."""
        ended = super().shutdown(timeout_sec)
        own = threading.get_ident() in self._workers
        self._executor.shutdown(wait=wait_for_threads and ended and not own)
        return ended
