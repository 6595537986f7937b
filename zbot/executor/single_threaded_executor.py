"""Executor that runs all callbacks in one thread."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING

from zbot.executor.executor import Executor, restores_executor

if TYPE_CHECKING:
    from collections.abc import Callable


class SingleThreadedExecutor(Executor):
    """Runs every callback in the thread that spins."""

    @restores_executor
    def spin(self) -> None:
        """Run callbacks until the context or this executor is shut down.

        Raises:
            ExternalShutdownException: A signal came, or the context was shut down during a wait.
        """
        if self._has_own("spin_once"):
            super().spin()  # it calls the program's method
            return
        self._begin_spin()
        try:
            while self._context.is_running and not self._is_shutdown:
                self._must_requeue = False
                work = self._next_work(None)
                if work is not None:
                    self._due_ns = self._timers.earliest_ns()
                    self._must_requeue = self._must_requeue or bool(self._ready)
                    self._execute(*work)
                    self._current = None
        finally:
            self._end_spin()
        self._raise_interruption()

    @restores_executor
    def _spin_once(self, deadline_ns: int | None, stop: Callable[[], bool] | None = None) -> None:
        if self._spinning_thread == threading.get_ident():
            self._serve_next(deadline_ns, stop)
            return
        if not self._begin_turn(deadline_ns):
            return
        try:
            work = self._next_work(deadline_ns, stop)
            self._must_requeue = True  # run one callback only
            if work is not None:
                self._execute(*work)
                self._current = None
        finally:
            self._end_spin()
