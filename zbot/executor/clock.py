"""Clocks with system, steady or ROS time. They can sleep, and call functions at time jumps."""

from __future__ import annotations

import contextlib
import enum
import importlib
import queue
import threading
import time
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, Protocol, overload

from zbot.errors import ArgumentTypeError, WrongValueError
from zbot.executor.errors import clock_type_error
from zbot.executor.sleepers import Sleepers
from zbot.process import signals
from zbot.threads.wakeup import LONGEST_WAIT_S, WakerSource, waking
from zbot.time import ClockType, Duration, Time

if TYPE_CHECKING:
    from collections.abc import Callable

    from typing_extensions import Self

__all__ = [
    "Clock",
    "ClockChange",
    "JumpHandle",
    "JumpThreshold",
    "ROSClock",
    "TimeChangeHandle",
    "TimeJump",
]


class SleepContext(WakerSource, Protocol):
    """The part of a context that a sleep uses. It calls wakers when `is_running` may change."""

    @property
    def is_running(self) -> bool:
        """Whether the context is initialised and not shut down."""
        ...


class ClockChange(enum.IntEnum):
    """Kinds of jumps: a change between system time and simulated time, or no such change."""

    ROS_TIME_NO_CHANGE = 1  #: simulated time before and after
    ROS_TIME_ACTIVATED = 2
    ROS_TIME_DEACTIVATED = 3
    SYSTEM_TIME_NO_CHANGE = 4  #: system time before and after


@dataclass(frozen=True)
class TimeJump:
    """A jump of a clock's time."""

    clock_change: ClockChange
    delta: Duration  #: new time minus old time, or zero if the source of time changed

    def __post_init__(self) -> None:
        if not isinstance(self.clock_change, ClockChange):
            raise ArgumentTypeError("clock_change", "a ClockChange", self.clock_change)


class JumpThreshold:
    """The smallest jumps for which a jump callback is called.

    Args:
        min_forward: The smallest jump forward, more than zero. `None` ignores jumps forward.
        min_backward: The smallest jump backward, less than zero. `None` ignores jumps backward.
        on_clock_change: Whether a switch between system time and simulated time counts as a jump.

    Raises:
        WrongValueError: A duration has the wrong sign, or no jump can reach the threshold.
    """

    def __init__(
        self,
        *,
        min_forward: Duration | None,
        min_backward: Duration | None,
        on_clock_change: bool = True,
    ) -> None:
        if min_forward is not None and min_forward.nanoseconds <= 0:
            raise WrongValueError(f"min_forward must be a positive duration, not {min_forward}")
        if min_backward is not None and min_backward.nanoseconds >= 0:
            raise WrongValueError(f"min_backward must be a negative duration, not {min_backward}")
        if min_forward is None and min_backward is None and not on_clock_change:
            raise WrongValueError("at least one jump threshold must be enabled")
        self.min_forward = min_forward
        self.min_backward = min_backward
        self.on_clock_change = on_clock_change

    def is_reached(self, jump: TimeJump) -> bool:
        """Return whether a jump reaches the threshold."""
        if jump.clock_change in {ClockChange.ROS_TIME_ACTIVATED, ClockChange.ROS_TIME_DEACTIVATED}:
            return self.on_clock_change
        delta_ns = jump.delta.nanoseconds
        if delta_ns > 0:
            return self.min_forward is not None and delta_ns >= self.min_forward.nanoseconds
        return self.min_backward is not None and delta_ns <= self.min_backward.nanoseconds


class JumpHandle:
    """Registration of jump callbacks, until `unregister()` or the end of a `with` block.

    Args:
        clock: The clock.
        threshold: The jumps for which the callbacks are called.
        pre_callback: Called before the time changes.
        post_callback: Called with a `TimeJump` after the time changed.

    Raises:
        WrongValueError: There is no callback, or a callback cannot be called.
    """

    def __init__(
        self,
        *,
        clock: Clock,
        threshold: JumpThreshold,
        pre_callback: Callable[[], Any] | None,
        post_callback: Callable[[TimeJump], Any] | None,
    ) -> None:
        if pre_callback is None and post_callback is None:
            raise WrongValueError("one of pre_callback or post_callback must be given")
        _check_callable("pre_callback", pre_callback)
        _check_callable("post_callback", post_callback)
        self.threshold = threshold
        self.pre_callback, self.post_callback = pre_callback, post_callback
        self._jumps = clock._jumps  # noqa: SLF001 - a handle is part of its clock
        self._jumps.append(self)

    def unregister(self) -> None:
        """Stop calling the callbacks. A second call does nothing."""
        with contextlib.suppress(ValueError):
            self._jumps.remove(self)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exc_info: object) -> None:
        self.unregister()


class TimeChangeHandle:
    """Registration of a callback of `on_time_change`, until `unregister()`."""

    def __init__(self, clock: Clock, callback: Callable[[], Any]) -> None:
        self.callback = callback
        self._changes = clock._changes  # noqa: SLF001 - a handle is part of its clock
        self._changes.append(self)

    def unregister(self) -> None:
        """Stop calling the callback. A second call does nothing."""
        with contextlib.suppress(ValueError):
            self._changes.remove(self)


class Clock:
    """A clock of one type. `Clock(clock_type=ClockType.ROS_TIME)` makes a `ROSClock`.

    All methods may be called from any thread.

    Args:
        clock_type: System time, steady time or ROS time.

    Raises:
        ArgumentTypeError: `clock_type` is not a `ClockType`, or it is `UNINITIALIZED`.
    """

    @overload
    def __new__(cls, *, clock_type: Literal[ClockType.ROS_TIME]) -> ROSClock: ...
    @overload
    def __new__(cls, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> Clock: ...
    def __new__(cls, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> Clock:
        """Create a `ROSClock` for ROS time, else a `Clock`."""
        is_ros = cls is Clock and clock_type is ClockType.ROS_TIME
        return object.__new__(ROSClock if is_ros else cls)

    def __init__(self, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> None:
        if not isinstance(clock_type, ClockType) or clock_type is ClockType.UNINITIALIZED:
            raise ArgumentTypeError(
                "clock_type", "ClockType.SYSTEM_TIME, STEADY_TIME or ROS_TIME", clock_type
            )
        self._clock_type = clock_type
        self._is_steady = clock_type is ClockType.STEADY_TIME
        self._source_changes = 0  # how often the source of time changed
        # No lock is used, because it could block a signal handler. A lock is not needed, because
        # Python changes a list in one atomic step, and copies a list in one atomic step.
        self._jumps: list[JumpHandle] = []
        self._changes: list[TimeChangeHandle] = []

    @property
    def clock_type(self) -> ClockType:
        """The clock's type: system time, steady time or ROS time."""
        return self._clock_type

    @property
    def handle(self) -> Clock:
        """The clock itself. In contrast to rclpy, a clock has no separate handle."""
        return self

    def __enter__(self) -> Self:
        """Do nothing. Programs use rclpy's `handle` of a clock in a `with` block."""
        return self

    def __exit__(self, *exc_info: object) -> None:
        """See `__enter__`."""

    def __repr__(self) -> str:
        return f"Clock(clock_type={self._clock_type.name})"

    def now(self) -> Time:
        """Return the present time. Its clock type is this clock's type."""
        return Time(nanoseconds=self._now_ns(), clock_type=self._clock_type)

    def _now_ns(self) -> int:
        return time.monotonic_ns() if self._is_steady else time.time_ns()

    def create_jump_callback(
        self,
        threshold: JumpThreshold,
        *,
        pre_callback: Callable[[], Any] | None = None,
        post_callback: Callable[[TimeJump], Any] | None = None,
    ) -> JumpHandle:
        """Call functions before and after each jump of simulated time.

        The thread that sets the time calls the functions, so they must be quick. If a function
        raises an exception, the code that sets the time gets it, and the other functions are not
        called.

        Args:
            threshold: The jumps for which the functions are called.
            pre_callback: Called before the time changes. If this function raises an exception, the
                time does not change.
            post_callback: Called with a `TimeJump` after the time changed.

        Raises:
            WrongValueError: There is no callback, or a callback cannot be called.
        """
        return JumpHandle(
            clock=self,
            threshold=threshold,
            pre_callback=pre_callback,
            post_callback=post_callback,
        )

    def on_time_change(self, callback: Callable[[], Any]) -> TimeChangeHandle:
        """Call a quick function after simulated time was set, activated or deactivated.

        The thread that sets the time calls the function. Clocks without simulated time never call
        the function.
        """
        return TimeChangeHandle(self, callback)

    def sleep_until(self, until: Time, context: SleepContext | None = None) -> bool:
        """Sleep until a time of this clock. The call ends immediately if that time is past.

        On simulated time the sleep never ends if no node publishes `/clock`.

        Args:
            until: A time of the same clock type.
            context: The shutdown of this context ends the sleep. If left out, the default context
                is used.

        Returns:
            `True` if the time was reached. `False` if the context was shut down, or if simulated
            time was activated or deactivated, because `until` has no meaning after that.

        Raises:
            WrongValueError: `until` is of another clock type.
            NotInitializedError: The context is not initialised, or it was shut down.
            ArgumentTypeError: `until` is not a `Time`.
        """
        if not isinstance(until, Time):
            raise ArgumentTypeError("until", "a Time", until)
        context = _default_context() if context is None else context
        if not context.is_running:
            signals.raise_not_initialized("a clock's sleep")
        if until.clock_type is not self._clock_type:
            raise clock_type_error(self._clock_type.name, until.clock_type.name)
        return self._sleep(until.nanoseconds, context)

    def sleep_for(self, rel_time: Duration, context: SleepContext | None = None) -> bool:
        """Sleep for a duration of this clock's time, like `sleep_until`."""
        return self.sleep_until(self.now() + rel_time, context)

    def _sleep(self, until_ns: int, context: SleepContext) -> bool:
        # A signal handler may wake the thread that it interrupted. Only SimpleQueue promises that
        # this is safe. A SimpleQueue also keeps a wake-up that comes before the wait.
        wakeups: queue.SimpleQueue[None] = queue.SimpleQueue()

        def wake() -> None:
            wakeups.put(None)

        source_changes = self._source_changes
        with waking(wake, context), contextlib.ExitStack() as at_end:
            at_end.callback(self.on_time_change(wake).unregister)
            while context.is_running and self._source_changes == source_changes:
                left_ns = until_ns - self._now_ns()
                if left_ns <= 0:
                    return True
                with contextlib.suppress(queue.Empty):
                    wakeups.get(timeout=self._wait_s(left_ns))
            return False

    def _wait_s(self, left_ns: int) -> float:
        return min(left_ns / 1e9, LONGEST_WAIT_S)


class ROSClock(Clock):
    """A node's clock. It has system time, or simulated time while `ros_time_is_active` is true."""

    def __new__(cls, *, clock_type: ClockType = ClockType.ROS_TIME) -> Self:
        """Create a clock of ROS time. Every other type is an error."""
        if clock_type is not ClockType.ROS_TIME:
            raise ArgumentTypeError("a ROSClock's clock_type", "ClockType.ROS_TIME", clock_type)
        return object.__new__(cls)

    def __init__(self, *, clock_type: ClockType = ClockType.ROS_TIME) -> None:
        super().__init__(clock_type=clock_type)
        self._is_simulated = False
        self._simulated_ns = 0
        # Re-entrant: a callback may set the time again.
        self._jump_lock = threading.RLock()
        self.sleepers = Sleepers()

    @property
    def ros_time_is_active(self) -> bool:
        """Whether the time is simulated."""
        return self._is_simulated

    def set_ros_time_is_active(self, active: bool) -> None:
        """Switch between system time and simulated time. The node's time source calls this."""
        with self._jump_lock:
            if active == self._is_simulated:
                return
            change = ClockChange.ROS_TIME_ACTIVATED if active else ClockChange.ROS_TIME_DEACTIVATED
            self._jump(TimeJump(change, Duration()), self._simulated_ns, is_simulated=active)

    _set_ros_time_is_active = set_ros_time_is_active  # rclpy's name, which tests of programs use

    def set_ros_time_override(self, time: Time) -> None:
        """Set the simulated time. `now()` returns it only while simulated time is active.

        Raises:
            ArgumentTypeError: `time` is not a `Time`.
        """
        if not isinstance(time, Time):
            raise ArgumentTypeError("time", "a Time", time)
        with self._jump_lock:
            if not self._is_simulated:
                self._simulated_ns = time.nanoseconds
                return
            delta = Duration(nanoseconds=time.nanoseconds - self._simulated_ns)
            jump = TimeJump(ClockChange.ROS_TIME_NO_CHANGE, delta)
            self._jump(jump, time.nanoseconds, is_simulated=True)

    def _jump(self, jump: TimeJump, simulated_ns: int, *, is_simulated: bool) -> None:
        reached = [handle for handle in list(self._jumps) if handle.threshold.is_reached(jump)]
        for handle in reached:
            if handle.pre_callback is not None:
                handle.pre_callback()
        self._source_changes += is_simulated is not self._is_simulated
        self._simulated_ns, self._is_simulated = simulated_ns, is_simulated
        try:
            for handle in reached:
                if handle.post_callback is not None:
                    handle.post_callback(jump)
        finally:
            for change in list(self._changes):
                change.callback()

    def _now_ns(self) -> int:
        return self._simulated_ns if self._is_simulated else time.time_ns()

    def _sleep(self, until_ns: int, context: SleepContext) -> bool:
        self.sleepers.begin(until_ns)
        try:
            return super()._sleep(until_ns, context)
        finally:
            self.sleepers.end()

    def _wait_s(self, left_ns: int) -> float:
        # Simulated time may be faster or slower than real time, so the real wait is not known.
        return LONGEST_WAIT_S if self._is_simulated else super()._wait_s(left_ns)


def _check_callable(argument: str, callback: object) -> None:
    if callback is not None and not callable(callback):
        raise WrongValueError(f"{argument} must be callable, not {callback!r}")


def _default_context() -> SleepContext:
    # Imported here, so that the import of this module does not load `zbot.context`.
    context: SleepContext = importlib.import_module("zbot.context").get_default_context()
    return context
