"""Clocks: what time it is, sleeping until then, and being told when simulated time moves."""

from __future__ import annotations

import contextlib
import enum
import importlib
import queue
import sys
import threading
import time
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, Protocol, overload

from zbot.errors import ArgumentTypeError, NotInitializedError
from zbot.executor.errors import ClockTypeError, InvalidJumpError
from zbot.time import ClockType, Duration, Time

if TYPE_CHECKING:
    from collections.abc import Callable
    from types import TracebackType

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

# Ctrl-C does not interrupt a wait on Windows, and elsewhere not if it comes just before Python goes
# to sleep.
_LONGEST_WAIT_S = 0.1 if sys.platform == "win32" else 0.5


class WakingContext(Protocol):
    """What a sleep needs of a context."""

    def ok(self) -> bool:
        """Return whether it is initialised and not shut down."""
        ...

    def add_waker(self, waker: Callable[[], None]) -> None:
        """Call a function whenever `ok()` may have changed."""
        ...

    def remove_waker(self, waker: Callable[[], None]) -> None:
        """Stop calling it."""
        ...


class ClockChange(enum.IntEnum):
    """Whether a jump came with a change between the system's and simulated time."""

    ROS_TIME_NO_CHANGE = 1  #: simulated before and after
    ROS_TIME_ACTIVATED = 2
    ROS_TIME_DEACTIVATED = 3
    SYSTEM_TIME_NO_CHANGE = 4  #: the system's before and after


@dataclass(frozen=True)
class TimeJump:
    """What happened to a clock."""

    clock_change: ClockChange
    delta: Duration  #: new time less old; zero if the source of time changed

    def __post_init__(self) -> None:
        if not isinstance(self.clock_change, ClockChange):
            raise ArgumentTypeError("clock_change", "a ClockChange", self.clock_change)


class JumpThreshold:
    """How large a jump must be to be told of.

    Args:
        min_forward: The least step forward, more than zero; `None` for never.
        min_backward: The least step backward, less than zero; `None` for never.
        on_clock_change: Whether to be told when simulated time is activated or deactivated.

    Raises:
        InvalidJumpError: A duration has the wrong sign, or nothing at all would be told.
    """

    def __init__(
        self,
        *,
        min_forward: Duration | None,
        min_backward: Duration | None,
        on_clock_change: bool = True,
    ) -> None:
        if min_forward is not None and min_forward.nanoseconds <= 0:
            raise InvalidJumpError(f"min_forward must be a positive duration, not {min_forward}")
        if min_backward is not None and min_backward.nanoseconds >= 0:
            raise InvalidJumpError(f"min_backward must be a negative duration, not {min_backward}")
        if min_forward is None and min_backward is None and not on_clock_change:
            raise InvalidJumpError("at least one jump threshold must be enabled")
        self.min_forward = min_forward
        self.min_backward = min_backward
        self.on_clock_change = on_clock_change

    def is_reached(self, jump: TimeJump) -> bool:
        """Return whether a jump is to be told."""
        if jump.clock_change in {ClockChange.ROS_TIME_ACTIVATED, ClockChange.ROS_TIME_DEACTIVATED}:
            return self.on_clock_change
        delta_ns = jump.delta.nanoseconds
        if delta_ns > 0:
            return self.min_forward is not None and delta_ns >= self.min_forward.nanoseconds
        return self.min_backward is not None and delta_ns <= self.min_backward.nanoseconds


class JumpHandle:
    """Keeps callbacks for jumps registered until `unregister()` or the end of a `with` block.

    Args:
        clock: The clock.
        threshold: Which jumps to tell.
        pre_callback: Called before the time changes.
        post_callback: Called with a `TimeJump` after the time changed.

    Raises:
        InvalidJumpError: There is no callback, or one cannot be called.
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
            raise InvalidJumpError("one of pre_callback or post_callback must be given")
        _check_callable("pre_callback", pre_callback)
        _check_callable("post_callback", post_callback)
        self.threshold = threshold
        self.pre_callback, self.post_callback = pre_callback, post_callback
        self._jumps = clock._jumps  # noqa: SLF001 - a handle is part of its clock
        self._jumps.append(self)

    def unregister(self) -> None:
        """Call the callbacks no more; may be called twice."""
        with contextlib.suppress(ValueError):
            self._jumps.remove(self)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        t: type[BaseException] | None,
        v: BaseException | None,
        tb: TracebackType | None,
    ) -> None:
        self.unregister()


class TimeChangeHandle:
    """Keeps a callback of `on_time_change` registered until `unregister()`."""

    def __init__(self, clock: Clock, callback: Callable[[], Any]) -> None:
        self.callback = callback
        self._changes = clock._changes  # noqa: SLF001 - a handle is part of its clock
        self._changes.append(self)

    def unregister(self) -> None:
        """Call the callback no more; may be called twice."""
        with contextlib.suppress(ValueError):
            self._changes.remove(self)


class Clock:
    """A clock of one type; `Clock(clock_type=ClockType.ROS_TIME)` makes a `ROSClock`.

    All methods may be called from any thread.

    Args:
        clock_type: The system's time, steady time or ROS time.

    Raises:
        ArgumentTypeError: It is no clock type that a clock can have.
    """

    @overload
    def __new__(cls, *, clock_type: Literal[ClockType.ROS_TIME]) -> ROSClock: ...
    @overload
    def __new__(cls, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> Clock: ...
    def __new__(cls, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> Clock:
        """Choose the class by the type."""
        is_ros = cls is Clock and clock_type is ClockType.ROS_TIME
        return object.__new__(ROSClock if is_ros else cls)

    def __init__(self, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> None:
        if not isinstance(clock_type, ClockType) or clock_type is ClockType.UNINITIALIZED:
            raise ArgumentTypeError(
                "clock_type", "ClockType.SYSTEM_TIME, STEADY_TIME or ROS_TIME", clock_type
            )
        self._clock_type = clock_type
        self._is_steady = clock_type is ClockType.STEADY_TIME
        self._switches = 0  # how often the source of time changed
        # Lists are changed and copied in one step each: no lock that a signal's handler could meet.
        self._jumps: list[JumpHandle] = []
        self._changes: list[TimeChangeHandle] = []

    @property
    def clock_type(self) -> ClockType:
        """What its times count from."""
        return self._clock_type

    @property
    def handle(self) -> Clock:
        """The clock itself: there is nothing beneath it, unlike in rclpy."""
        return self

    def __enter__(self) -> Self:
        """Do nothing: programs hold rclpy's `handle` of a clock like that."""
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc_val: BaseException | None,
        exc_tb: TracebackType | None,
    ) -> None:
        """See `__enter__`."""

    def __repr__(self) -> str:
        return f"Clock(clock_type={self._clock_type.name})"

    def now(self) -> Time:
        """Return the present time, of this clock's type."""
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
        """Call functions before and after simulated time jumps.

        They are called in the thread that sets the time and must be quick. An exception reaches
        whoever sets the time, and the callbacks after it are not called.

        Args:
            threshold: Which jumps to tell.
            pre_callback: Called before the time changes; if it raises, the time stays.
            post_callback: Called with a `TimeJump` after the time changed.

        Raises:
            InvalidJumpError: There is no callback, or one cannot be called.
        """
        return JumpHandle(
            clock=self,
            threshold=threshold,
            pre_callback=pre_callback,
            post_callback=post_callback,
        )

    def on_time_change(self, callback: Callable[[], Any]) -> TimeChangeHandle:
        """Call a quick function whenever simulated time was set, activated or deactivated.

        It is called in the thread that did so, when the new time shows already. Clocks without
        simulated time never call.
        """
        return TimeChangeHandle(self, callback)

    def sleep_until(self, until: Time, context: WakingContext | None = None) -> bool:
        """Sleep until a time of this clock; not at all if it is past.

        On simulated time this lasts for ever if nobody publishes `/clock`.

        Args:
            until: A time of the same clock type.
            context: Its shutdown ends the sleep; the default context if left out.

        Returns:
            Whether the time was reached; `False` if the context was shut down, or simulated time
            was activated or deactivated and `until` lost its meaning.

        Raises:
            ClockTypeError: `until` is of another clock type.
            NotInitializedError: The context is not initialised or shut down already.
            ArgumentTypeError: `until` is no `Time`.
        """
        if not isinstance(until, Time):
            raise ArgumentTypeError("until", "a Time", until)
        context = _default_context() if context is None else context
        if not context.ok():
            raise NotInitializedError("a clock's sleep")
        if until.clock_type is not self._clock_type:
            raise ClockTypeError(self._clock_type.name, until.clock_type.name)
        return self._sleep(until.nanoseconds, context)

    def sleep_for(self, rel_time: Duration, context: WakingContext | None = None) -> bool:
        """Sleep for a duration of this clock's time; else like `sleep_until`."""
        return self.sleep_until(self.now() + rel_time, context)

    def _sleep(self, until_ns: int, context: WakingContext) -> bool:
        # A signal's handler may wake the thread that it interrupted: of all that threads can wait
        # for, only SimpleQueue promises to stand that, and never loses what came too early.
        alarm: queue.SimpleQueue[None] = queue.SimpleQueue()

        def wake() -> None:
            alarm.put(None)

        switches = self._switches
        context.add_waker(wake)
        handle = self.on_time_change(wake)
        try:
            while context.ok() and self._switches == switches:
                left_ns = until_ns - self._now_ns()
                if left_ns <= 0:
                    return True
                with contextlib.suppress(queue.Empty):
                    alarm.get(timeout=self._patience_s(left_ns))
            return False
        finally:
            handle.unregister()
            context.remove_waker(wake)

    def _patience_s(self, left_ns: int) -> float:
        return min(left_ns / 1e9, _LONGEST_WAIT_S)


class ROSClock(Clock):
    """A node's clock: the system's time, or simulated time while that is active."""

    def __new__(cls, *, clock_type: ClockType = ClockType.ROS_TIME) -> Self:
        """Make a clock of ROS time; there is no other type of it."""
        if clock_type is not ClockType.ROS_TIME:
            raise ArgumentTypeError("a ROSClock's clock_type", "ClockType.ROS_TIME", clock_type)
        return object.__new__(cls)

    def __init__(self, *, clock_type: ClockType = ClockType.ROS_TIME) -> None:
        super().__init__(clock_type=clock_type)
        self._is_simulated = False
        self._simulated_ns = 0
        # Re-entrant, for a callback may set the time again.
        self._moving = threading.RLock()

    @property
    def ros_time_is_active(self) -> bool:
        """Whether the time is simulated."""
        return self._is_simulated

    def set_ros_time_is_active(self, active: bool) -> None:
        """Switch between the system's time and simulated time. For the node's time source."""
        with self._moving:
            if active == self._is_simulated:
                return
            change = ClockChange.ROS_TIME_ACTIVATED if active else ClockChange.ROS_TIME_DEACTIVATED
            self._jump(TimeJump(change, Duration()), self._simulated_ns, is_simulated=active)

    _set_ros_time_is_active = set_ros_time_is_active  # rclpy's name; tests of programs call it

    def set_ros_time_override(self, time: Time) -> None:
        """Set the simulated time, which shows only while simulated time is active.

        Raises:
            ArgumentTypeError: It is no `Time`.
        """
        if not isinstance(time, Time):
            raise ArgumentTypeError("time", "a Time", time)
        with self._moving:
            if not self._is_simulated:
                self._simulated_ns = time.nanoseconds
                return
            delta = Duration(nanoseconds=time.nanoseconds - self._simulated_ns)
            jump = TimeJump(ClockChange.ROS_TIME_NO_CHANGE, delta)
            self._jump(jump, time.nanoseconds, is_simulated=True)

    def _jump(self, jump: TimeJump, simulated_ns: int, *, is_simulated: bool) -> None:
        told = [handle for handle in list(self._jumps) if handle.threshold.is_reached(jump)]
        for handle in told:
            if handle.pre_callback is not None:
                handle.pre_callback()
        self._switches += is_simulated is not self._is_simulated
        self._simulated_ns, self._is_simulated = simulated_ns, is_simulated
        try:
            for handle in told:
                if handle.post_callback is not None:
                    handle.post_callback(jump)
        finally:
            for change in list(self._changes):
                change.callback()

    def _now_ns(self) -> int:
        return self._simulated_ns if self._is_simulated else time.time_ns()

    def _patience_s(self, left_ns: int) -> float:
        # What is left of simulated time says nothing about how long it takes.
        return _LONGEST_WAIT_S if self._is_simulated else super()._patience_s(left_ns)


def _check_callable(argument: str, callback: object) -> None:
    if callback is not None and not callable(callback):
        raise InvalidJumpError(f"{argument} must be callable, not {callback!r}")


def _default_context() -> WakingContext:
    # By name, for the context is a layer above the clock.
    context: WakingContext = importlib.import_module("zbot.context").get_default_context()
    return context
