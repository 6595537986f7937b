"""Futures, and tasks that run functions and coroutines step by step in an executor.

A step of a coroutine ends at the next `await` that has to wait.
"""

from __future__ import annotations

import contextlib
import inspect
import sys
import threading
import warnings
import weakref
from enum import Enum
from typing import TYPE_CHECKING, Any, Generic, TypeVar, cast

from zbot.errors import ExternalShutdownException
from zbot.executor.callback_check import check_callback
from zbot.executor.callback_group import ReentrantCallbackGroup
from zbot.threads.wakeup import waking

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Generator

    from typing_extensions import Self

    from zbot.executor.callback_group import CallbackGroup

T = TypeVar("T")
_ALWAYS = ReentrantCallbackGroup()


class FutureState(Enum):
    """Whether a future is pending, cancelled or finished."""

    PENDING = "PENDING"
    CANCELLED = "CANCELLED"
    FINISHED = "FINISHED"


# An attribute of an enum takes time to look up, and every service call needs several.
_PENDING, _CANCELLED = FutureState.PENDING, FutureState.CANCELLED
_FINISHED = FutureState.FINISHED


class _CurrentStep(threading.local):
    """The asyncio event loop that was running when this thread's present step began, if any."""

    loop: object = None


_current_step = _CurrentStep()


def _running_loop() -> object:
    asyncio = sys.modules.get("asyncio")  # not imported here: that takes long
    if asyncio is None:
        return None
    try:
        return asyncio.get_running_loop()
    except RuntimeError:
        return None


class Future(Generic[T]):
    """A result that comes later. `await` it, or give it to `spin_until_future_complete`.

    If the future has an executor, the executor runs the done callbacks. Otherwise the thread that
    completes the future runs them.

    Args:
        executor: Runs the done callbacks. It may be left out.
    """

    def __init__(self, *, executor: Any = None) -> None:
        # A weak reference avoids a reference cycle, because the executor refers to its tasks.
        self._executor = None if executor is None else weakref.ref(executor)
        self._lock = threading.RLock()  # re-entrant, because a signal handler may use it
        self._state = _PENDING
        self._result: T | None = None
        self._exception: BaseException | None = None
        self._callbacks: list[Callable[[Any], Any]] = []
        self._wakers: list[Callable[[], object]] = []

    def __await__(self) -> Generator[Any, None, T | None]:
        while not self.is_over:
            loop = _running_loop()
            if loop is _current_step.loop:
                yield self
            else:  # a program without an executor has started the loop, or the present step has
                yield from self._wait_in(loop)
        return self.result()

    def _wait_in(self, loop: Any) -> Generator[Any, None, None]:
        """Let an event loop of asyncio wait, which takes no computing time."""
        wait = loop.create_future()

        def end() -> None:
            if not wait.done():  # a timeout of asyncio may have ended it
                wait.set_result(None)

        def wake() -> None:
            with contextlib.suppress(RuntimeError):  # the loop was closed meanwhile
                loop.call_soon_threadsafe(end)

        with waking(wake, self):
            yield from wait

    def cancel(self) -> None:
        """Cancel the future and run its done callbacks. Do nothing if the future is over."""
        self._complete(_CANCELLED)

    def cancelled(self) -> bool:
        """Return whether the future was cancelled."""
        return self._state is _CANCELLED

    def done(self) -> bool:
        """Return whether a result or exception is set. A cancelled future is never done."""
        return self._state is _FINISHED

    @property
    def is_over(self) -> bool:
        """Whether the future is done or cancelled."""
        return self._state is not _PENDING

    def result(self) -> T | None:
        """Return the result, or `None` if it is not set yet. Raise the exception if one is set."""
        if self._exception is not None:
            raise self._exception
        return self._result

    def exception(self) -> BaseException | None:
        """Return the exception that was set, if any."""
        return self._exception

    def set_result(self, result: T) -> None:
        """Complete with a result, which replaces an earlier result. An earlier exception stays."""
        self._complete(_FINISHED, result=result, replace=True)

    def set_exception(self, exception: BaseException) -> None:
        """Complete with an exception, which `result()` and `await` raise from now on."""
        self._complete(_FINISHED, exception=exception, replace=True)

    def add_done_callback(self, callback: Callable[[Self], Any]) -> None:
        """Call `callback(self)` when the future is over, or immediately if it is over already.

        An exception of a callback that is called immediately passes through.

        Raises:
            WrongTypeError: The callback is not callable.
            WrongStateError: The callback does not take one argument.
        """
        check_callback("add_done_callback", callback, "(future)")
        with self._lock:
            if not self.is_over:
                self._callbacks.append(callback)
                return
        self._run(callback)

    def add_waker(self, waker: Callable[[], object]) -> None:
        """Call a quick function when the future is over, in the thread that completes the future.

        If the future is over already, call the function immediately.
        """
        with self._lock:
            if not self.is_over:
                self._wakers.append(waker)
                return
        waker()

    def remove_waker(self, waker: Callable[[], object]) -> None:
        """Remove a function that was given to `add_waker`. Do nothing if the future is over."""
        with self._lock:
            if waker in self._wakers:
                self._wakers.remove(waker)

    def remove_done_callback(self, callback: Callable[[Self], Any]) -> bool:
        """Remove every occurrence of a callback. Return whether there was an occurrence."""
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
        replace: bool = False,
    ) -> None:
        with self._lock:
            if self.is_over and not replace:
                return
            self._state = state
            if exception is None:
                self._result = result
            else:
                self._exception = exception
            wakers, self._wakers = self._wakers, []
        for waker in wakers:
            waker()
        self._run_callbacks()

    def _run_callbacks(self) -> None:
        for callback in self._pop_callbacks():
            try:
                self._run(callback)
            except ExternalShutdownException:
                raise  # a signal came during the callback
            except Exception as exc:  # noqa: BLE001 - as in rclpy, the completing thread goes on
                warnings.warn(f"Unhandled exception in done callback: {exc}", stacklevel=2)

    def _pop_callbacks(self) -> list[Callable[[Any], Any]]:
        with self._lock:
            callbacks, self._callbacks = self._callbacks, []
        return callbacks

    def _run(self, callback: Callable[[Any], Any]) -> None:
        executor = None if self._executor is None else self._executor()
        if executor is not None:
            executor.create_task(callback, self)
        else:
            callback(self)


class Task(Future[T]):
    """A function or coroutine that an executor runs step by step until it has a result.

    Args:
        handler: A function, a coroutine function, or a coroutine.
        args: Positional arguments of the function.
        kwargs: Keyword arguments of the function.
        executor: Runs the next step when the awaited future is over.
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
            check_callback("create_task", handler)
            function = cast("Callable[..., Any]", handler)
            self._coroutine = None
            self._call: Callable[[], Any] = lambda: function(*args, **(kwargs or {}))
        self._step_lock = threading.Lock()

    def __call__(self) -> None:
        """Run until the next `await` that has to wait, or to the end."""
        with self._step_lock:
            if not self.is_over:
                outer_loop, _current_step.loop = _current_step.loop, _running_loop()
                try:
                    self._step()
                except BaseException as exc:
                    self._complete(_FINISHED, exception=exc)
                    if not isinstance(exc, Exception):
                        raise
                finally:
                    _current_step.loop = outer_loop

    def executing(self) -> bool:
        """Return whether a thread runs a step now."""
        return self._step_lock.locked()

    def cancel(self) -> None:
        """Stop at the present `await`. A function that has begun runs to its end."""
        is_free = self._step_lock.acquire(blocking=False)  # no other thread can begin a step
        try:
            if is_free and self._coroutine is not None:
                self._coroutine.close()
            super().cancel()
        finally:
            if is_free:
                self._step_lock.release()

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
            # `_schedule` is added as a waker. A done callback would run in the future's executor,
            # but the task must continue in its own executor.
            awaited.add_waker(self._schedule)
        else:
            self._schedule()

    def _schedule(self) -> None:
        executor = None if self._executor is None else self._executor()
        if executor is not None:
            executor.schedule(self)


async def await_or_execute(callback: Callable[..., Any], *args: Any) -> Any:
    """Call a function, or call a coroutine function and await it. Return the result."""
    outcome = callback(*args)
    return await outcome if inspect.isawaitable(outcome) else outcome


class TaskStep:
    """The next step of a task. It runs once. The task schedules a new object for each step."""

    __slots__ = ("_is_taken", "callback_group", "task")
    due_ns: int | None = None
    ready_queue = None

    def __init__(self, task: Task[Any]) -> None:
        self.task = task
        self.callback_group: CallbackGroup = _ALWAYS
        self._is_taken = False

    def take(self) -> object | None:
        """Return this object once. Return `None` at later calls, and if the task is over."""
        if self._is_taken or self.task.is_over:
            return None
        self._is_taken = True
        return self

    def execute(self, taken: object) -> None:  # noqa: ARG002 - every entity's signature
        """Run the step, and raise the exception that the task raised."""
        self.task()
        if self.task.done():
            self.task.result()  # an exception ends spin(), as in rclpy
