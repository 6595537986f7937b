"""Futures, and the coroutines of callbacks as tasks that an executor runs."""

from __future__ import annotations

import inspect
import sys
import threading
import warnings
import weakref
from enum import Enum
from typing import TYPE_CHECKING, Any, Generic, TypeVar, cast

from zbot.errors import ExternalShutdownException

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Generator

    from typing_extensions import Self

T = TypeVar("T")


class FutureState(Enum):
    """How far a future is."""

    PENDING = "PENDING"
    CANCELLED = "CANCELLED"
    FINISHED = "FINISHED"


# Each member of an enum costs a look-up in its class, and every call of a service asks for some.
_PENDING, _CANCELLED = FutureState.PENDING, FutureState.CANCELLED
_FINISHED = FutureState.FINISHED


class _Step(threading.local):
    """The event loop of asyncio around the task's step that this thread runs, if any."""

    loop: object = None


_step = _Step()


def _running_loop() -> object:
    asyncio = sys.modules.get("asyncio")  # a program without it must not wait for its import
    if asyncio is None:
        return None
    try:
        return asyncio.get_running_loop()
    except RuntimeError:
        return None


class Future(Generic[T]):
    """A result that comes later: `await` it, or give it to `spin_until_future_complete`.

    Done callbacks run on the executor if the future has one, else on the thread that completes it.

    Args:
        executor: Runs the done callbacks; may be left out.
    """

    def __init__(self, *, executor: Any = None) -> None:
        # Weak, for an executor holds the tasks that hold it.
        self._executor = None if executor is None else weakref.ref(executor)
        self._lock = threading.RLock()  # re-entrant, for a signal's handler
        self._state = _PENDING
        self._result: T | None = None
        self._exception: BaseException | None = None
        self._callbacks: list[Callable[[Any], Any]] = []
        self._wakers: list[Callable[[], object]] = []

    def __await__(self) -> Generator[Future[T] | None, None, T | None]:
        while not self.is_over:
            # A loop that began inside the step, or without one, is who waits: it asks again later.
            yield self if _running_loop() is _step.loop else None
        return self.result()

    def cancel(self) -> None:
        """Mark as cancelled and run the done callbacks; nothing happens when already done."""
        self._complete(_CANCELLED)

    def cancelled(self) -> bool:
        """Return whether it was cancelled."""
        return self._state is _CANCELLED

    def done(self) -> bool:
        """Return whether a result or exception is set; a cancelled future is never done."""
        return self._state is _FINISHED

    @property
    def is_over(self) -> bool:
        """Whether nothing more will come: done or cancelled."""
        return self._state is not _PENDING

    def result(self) -> T | None:
        """Return the result, `None` while there is none; raise the exception if that was set."""
        if self._exception is not None:
            raise self._exception
        return self._result

    def exception(self) -> BaseException | None:
        """Return the exception that was set, if any."""
        return self._exception

    def set_result(self, result: T) -> None:
        """Complete with a result, in place of an earlier one; an exception that was set stays."""
        self._complete(_FINISHED, result=result, again=True)

    def set_exception(self, exception: BaseException) -> None:
        """Complete with an exception, which `result()` and `await` raise from now on."""
        self._complete(_FINISHED, exception=exception, again=True)

    def add_done_callback(self, callback: Callable[[Self], Any]) -> None:
        """Call `callback(self)` when done, at once if it is."""
        with self._lock:
            if not self.is_over:
                self._callbacks.append(callback)
                return
        self._run(callback)

    def add_waker(self, waker: Callable[[], object]) -> None:
        """Call a quick function when over, at once if it is, in the thread that completes it."""
        with self._lock:
            if not self.is_over:
                self._wakers.append(waker)
                return
        waker()

    def remove_done_callback(self, callback: Callable[[Self], Any]) -> bool:
        """Take every occurrence of a callback back; return whether there was one."""
        with self._lock:
            kept = [known for known in self._callbacks if known != callback]
            removed = len(kept) < len(self._callbacks)
            self._callbacks = kept
        return removed

    def _complete(
        self,
        state: FutureState,
        *,
        result: T | None = None,
        exception: BaseException | None = None,
        again: bool = False,
    ) -> None:
        with self._lock:
            if self.is_over and not again:
                return
            self._state = state
            if exception is None:
                self._result = result
            else:
                self._exception = exception
            wakers, self._wakers = self._wakers, []
        for waker in wakers:
            waker()
        self._tell()

    def _tell(self) -> None:
        for callback in self._pop_callbacks():
            self._run(callback)

    def _pop_callbacks(self) -> list[Callable[[Any], Any]]:
        with self._lock:
            callbacks, self._callbacks = self._callbacks, []
        return callbacks

    def _run(self, callback: Callable[[Any], Any]) -> None:
        executor = None if self._executor is None else self._executor()
        if executor is not None:
            executor.create_task(callback, self)
            return
        try:
            callback(self)
        except ExternalShutdownException:
            raise  # a signal came meanwhile
        except Exception as exc:  # noqa: BLE001 - as in rclpy, not the completing thread's concern
            warnings.warn(f"Unhandled exception in done callback: {exc}", stacklevel=2)


class Task(Future[T]):
    """A function or coroutine that an executor runs, step by step, until its result is there.

    Args:
        handler: A function, a coroutine function, or a coroutine.
        args: Positional arguments of the function.
        kwargs: Keyword arguments of the function.
        executor: Where the next step is scheduled when something awaited is ready.
    """

    def __init__(
        self,
        handler: Callable[..., Any] | Coroutine[Any, Any, T],
        args: tuple[Any, ...] = (),
        kwargs: dict[str, Any] | None = None,
        *,
        executor: Any = None,
    ) -> None:
        super().__init__(executor=executor)
        if inspect.iscoroutine(handler):
            self._coroutine: Coroutine[Any, Any, T] | None = handler
        else:
            function = cast("Callable[..., Any]", handler)
            self._coroutine = None
            self._call: Callable[[], Any] = lambda: function(*args, **(kwargs or {}))
        self._stepping = threading.Lock()

    def __call__(self) -> None:
        """Run until the next `await` that is not ready, or to the end."""
        with self._stepping:
            if not self.is_over:
                around, _step.loop = _step.loop, _running_loop()
                try:
                    self._step()
                except BaseException as exc:
                    self._complete(_FINISHED, exception=exc)
                    if not isinstance(exc, Exception):
                        raise
                finally:
                    _step.loop = around

    def executing(self) -> bool:
        """Return whether a thread is running a step right now."""
        return self._stepping.locked()

    def cancel(self) -> None:
        """Stop at the present `await`; a function that has begun runs to its end."""
        if self._coroutine is not None and not self.executing():
            self._coroutine.close()
        super().cancel()

    def _step(self) -> None:
        if self._coroutine is None:
            outcome = self._call()
            if not inspect.iscoroutine(outcome):
                self._complete(_FINISHED, result=outcome)
                return
            self._coroutine = outcome
        try:
            awaited = self._coroutine.send(None)
        except StopIteration as stop:
            self._complete(_FINISHED, result=stop.value)
        else:
            self._resume_after(awaited)

    def _resume_after(self, awaited: object) -> None:
        if isinstance(awaited, Future):
            # Added without the future's own executor in between: the task decides where it goes on.
            awaited.add_waker(self._schedule)
        else:
            self._schedule()

    def _schedule(self) -> None:
        executor = None if self._executor is None else self._executor()
        if executor is not None:
            executor.schedule(self)


async def await_or_execute(callback: Callable[..., Any], *args: Any) -> Any:
    """Return what a function or a coroutine function returns."""
    outcome = callback(*args)
    return await outcome if inspect.isawaitable(outcome) else outcome
