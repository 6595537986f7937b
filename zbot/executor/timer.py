"""Timers and rates. They follow any clock, and their periods do not drift."""

from __future__ import annotations

import contextlib
import threading
import time
from typing import TYPE_CHECKING, Any, NoReturn

from zbot.errors import InvalidHandleError, NotInitializedError
from zbot.executor.callback_check import check_callback, if_written
from zbot.executor.clock import ROSClock
from zbot.executor.errors import RateInterruptedBySignalError, RateInterruptedError
from zbot.log import get_logger
from zbot.process import signals
from zbot.threads.handle import Handle
from zbot.time import S_TO_NS, ClockType, Duration, Time

if TYPE_CHECKING:
    from collections.abc import Callable

    from typing_extensions import Self

    from zbot.context import Context
    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.clock import Clock
    from zbot.executor.ready_queue import ReadyQueue

_LATE_NS = 5 * 10**9  # a timer that is late for a shorter time is no mistake


class TimerInfo:
    """When a timer's call was due, and when it happened.

    Args:
        expected_call_time: Nanoseconds on the timer's clock.
        actual_call_time: Nanoseconds on the timer's clock.
        clock_type: The type of that clock.

    Raises:
        ArgumentTypeError: `clock_type` is not a `ClockType`.
        WrongValueError: A time is below 0.
    """

    __slots__ = ("actual_call_time", "expected_call_time")

    def __init__(
        self,
        *,
        expected_call_time: int = 0,
        actual_call_time: int = 0,
        clock_type: ClockType = ClockType.SYSTEM_TIME,
    ) -> None:
        self.expected_call_time = Time(nanoseconds=expected_call_time, clock_type=clock_type)
        self.actual_call_time = Time(nanoseconds=actual_call_time, clock_type=clock_type)


class Timer:
    """Calls a function every period. `Node.create_timer` creates timers.

    A late timer calls the function once, skips the missed periods, and keeps its period boundaries.
    So delays do not add up. With a simulated clock the timer follows `/clock`. With other
    clocks it follows the monotonic clock.

    Args:
        callback: Called without arguments, or with a `TimerInfo`. It may be a coroutine function.
        callback_group: Decides which callbacks may run at the same time.
        period_ns: Nanoseconds, 0 or more.
        clock: Clock of the `TimerInfo`. If the clock is simulated, the timer follows it.
        ready_queue: The node's ready queue.
        autostart: Whether the timer starts now. Otherwise `reset()` starts the timer.
        logger_name: The logger that warns once of a timer that is always late. The empty name means
            no warning.
    """

    def __init__(
        self,
        callback: Callable[..., Any] | None,
        callback_group: CallbackGroup,
        period_ns: int,
        clock: Clock,
        ready_queue: ReadyQueue,
        *,
        autostart: bool = True,
        logger_name: str = "",
    ) -> None:
        self._logger_name = logger_name
        self._late_since_ns = 0  # when it began to miss a period at each call
        self.callback = callback
        self.callback_group = callback_group
        self._clock = clock
        self.ready_queue = ready_queue
        self._period_ns = period_ns
        self._is_canceled = not autostart
        self._is_destroyed = False
        self._restart()
        self._subscription = (
            clock.on_time_change(self._on_time_change) if isinstance(clock, ROSClock) else None
        )

    @property
    def callback(self) -> Callable[..., Any] | None:
        """The function that the timer calls."""
        return self._callback

    @callback.setter
    def callback(self, callback: Callable[..., Any] | None) -> None:
        self._with_info = callback is not None and check_timer_callback("Timer.callback", callback)
        self._callback = callback

    @property
    def clock(self) -> Clock:
        """The timer's clock."""
        return self._clock

    @property
    def timer_period_ns(self) -> int:
        """The period in nanoseconds. A changed period is counted from the last call."""
        return self._period_ns

    @timer_period_ns.setter
    def timer_period_ns(self, value: int) -> None:
        self._period_ns = int(value)
        self._next_ns = self._last_ns + self._period_ns
        self.ready_queue.post(self)

    @property
    def due_ns(self) -> int | None:
        """When the timer is due (monotonic clock). `None` if canceled or on simulated time."""
        return None if self._is_canceled or self._is_simulated else self._next_ns

    @property
    def _is_simulated(self) -> bool:
        return isinstance(self._clock, ROSClock) and self._clock.ros_time_is_active

    def _now_ns(self) -> int:
        return self._clock.now().nanoseconds if self._is_simulated else time.monotonic_ns()

    def _restart(self) -> None:
        self._was_simulated = self._is_simulated
        self._last_ns = self._now_ns()
        self._next_ns = self._last_ns + self._period_ns

    def _on_time_change(self) -> None:
        # A jump forward does not restart the timer. Each message of `/clock` is such a jump. If its
        # length is more than the period, a timer that is restarted each time would never be due.
        is_simulated, now = self._is_simulated, self._now_ns()
        if is_simulated is not self._was_simulated or now < self._last_ns:
            self._restart()
            self.ready_queue.post(self)
        elif now >= self._next_ns and not self._is_canceled:
            # The timer is posted only when it is due, and not at each message of `/clock`.
            self.ready_queue.post(self)

    def take(self) -> TimerInfo | None:
        """Return the call that is due and schedule the next call, or return `None`."""
        now = self._now_ns()
        if self._is_canceled or now < self._next_ns:
            return None
        clock_now = self._clock.now()
        late_ns = now - self._next_ns
        self._last_ns = now
        behind = (now - self._next_ns) // self._period_ns if self._period_ns else 0
        if behind or self._late_since_ns:
            self._note_missed(now, behind)
        self._next_ns = self._next_ns + (behind + 1) * self._period_ns if self._period_ns else now
        return TimerInfo(
            expected_call_time=clock_now.nanoseconds - late_ns,
            actual_call_time=clock_now.nanoseconds,
            clock_type=clock_now.clock_type,
        )

    def _note_missed(self, now: int, behind: int) -> None:
        """Warn once if each call for some seconds has missed whole periods."""
        if not behind or self._is_simulated:
            self._late_since_ns = 0
        elif not self._late_since_ns:
            self._late_since_ns = now
        elif now - self._late_since_ns > _LATE_NS and self._logger_name:
            name = getattr(self._callback, "__qualname__", "")
            get_logger(self._logger_name).warning(
                f"the timer of {name} has a period of {self._period_ns / S_TO_NS:g} s, but its "
                f"calls come {behind + 1} periods apart: a callback takes too long, e.g. because "
                "it sleeps or waits"
            )
            self._logger_name = ""

    def execute(self, info: TimerInfo) -> Any:
        """Call the callback."""
        if self._is_canceled or self._callback is None:
            return None
        return self._callback(info) if self._with_info else self._callback()

    @property
    def is_destroyed(self) -> bool:
        """Whether the timer was destroyed. A destroyed timer never calls its callback."""
        return self._is_destroyed

    @property
    def handle(self) -> TimerHandle:
        """Handle for a `WaitSet`. A program without an executor calls the handle's `call_timer`."""
        return TimerHandle(self)

    @property
    def has_work(self) -> bool:
        """Whether a call is due."""
        return self.is_ready()

    def is_ready(self) -> bool:
        """Return whether a call is due."""
        return not self._is_canceled and self._now_ns() >= self._next_ns

    def is_canceled(self) -> bool:
        """Return whether the timer was canceled and has not been reset since."""
        return self._is_canceled

    def cancel(self) -> None:
        """Stop calling until `reset()`. A call that has begun ends normally."""
        self._is_canceled = True

    def reset(self) -> None:
        """Begin a new period now. A canceled timer starts again.

        Raises:
            InvalidHandleError: The timer was destroyed.
        """
        if self._is_destroyed:
            raise InvalidHandleError("the timer")
        self._restart()
        self._is_canceled = False
        self.ready_queue.post(self)

    def time_since_last_call(self) -> int:
        """Return the nanoseconds since the last call, or since the start."""
        return self._now_ns() - self._last_ns

    def time_until_next_call(self) -> int | None:
        """Return the nanoseconds until the next call, or `None` if the timer is canceled.

        The number is negative if the call is late.
        """
        return None if self._is_canceled else self._next_ns - self._now_ns()

    def destroy(self) -> None:
        """Never call the callback again. A second `destroy` does nothing."""
        self._is_destroyed = self._is_canceled = True
        if self._subscription is not None:
            self._subscription.unregister()
            self._subscription = None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exc_info: object) -> None:
        self.destroy()


class TimerHandle(Handle[Timer]):
    """A timer's handle."""

    def call_timer(self) -> None:
        """Take the call that is due, if any, without running the callback."""
        self.entity.take()

    def call_timer_with_info(self) -> TimerInfo | None:
        """Take the call that is due, and return its times. Return `None` if no call is due."""
        return self.entity.take()


def check_timer_callback(call: str, callback: Callable[..., Any] | None) -> bool:
    """Return whether a timer's callback takes a `TimerInfo`.

    Raises:
        WrongTypeError: The callback is not callable.
        WrongStateError: The callback accepts neither zero arguments nor one argument.
    """
    # In rclpy, a timer may have no callback, e.g. for a wait set.
    forms = ("()", "(timer_info)")
    return check_callback(call, callback, *forms, position=1, may_be_none=if_written) == 1


class _RateContext:
    """Context of a sleep. The sleep ends at `Rate.destroy` or a shutdown of the node's context."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._wakers: list[Callable[[], None]] = []
        self.is_destroyed = False

    @property
    def is_running(self) -> bool:
        return not self.is_destroyed and self._context.is_running

    def add_waker(self, waker: Callable[[], None]) -> None:
        self._wakers.append(waker)
        self._context.add_waker(waker)

    def remove_waker(self, waker: Callable[[], None]) -> None:
        self._wakers.remove(waker)
        self._context.remove_waker(waker)

    def destroy(self) -> None:
        self.is_destroyed = True
        for waker in list(self._wakers):
            waker()


class Rate:
    """Sleeps so that a loop runs at a frequency. `Node.create_rate` creates rates.

    In contrast to rclpy's rate, this rate needs no executor that spins in another thread.

    Args:
        timer: The rate has the timer's period and clock. As in rclpy, a `spin_once()` that waits in
            another thread returns when the timer is due.
        context: The shutdown of this context ends a sleep.
    """

    def __init__(self, timer: Timer, context: Context) -> None:
        self.timer = timer
        self._period = Duration(nanoseconds=timer.timer_period_ns)
        self._clock = timer.clock
        self._context = context
        self._sleep_context = _RateContext(context)
        self._next = self._clock.now() + self._period

    def sleep(self) -> None:
        """Sleep until the next multiple of the period, or until the rate is destroyed.

        If the time to wake up is past, the call ends immediately.

        Raises:
            RateInterruptedError: The context was shut down, or a signal came. After a signal,
                Python prints no traceback if the program does not catch the exception.
            InvalidHandleError: The rate was destroyed before this call.
        """
        if self._sleep_context.is_destroyed:
            raise InvalidHandleError("the rate")
        now = self._clock.now()
        if now >= self._next + self._period:  # the loop took too long: new period boundaries
            self._next = now
        with contextlib.suppress(NotInitializedError):  # another thread shut down the context
            self._clock.sleep_until(self._next, self._sleep_context)
        self._next += self._period
        if not self._context.is_running:
            self._raise_interruption()

    def _raise_interruption(self) -> NoReturn:
        if self._context.is_interrupted and threading.current_thread() is threading.main_thread():
            raise RateInterruptedBySignalError(signals.last_signal())
        raise RateInterruptedError

    def destroy(self) -> None:
        """End the `sleep` of another thread. Every later `sleep` raises an error."""
        self._sleep_context.destroy()
