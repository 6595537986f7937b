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

from zbot.errors import ArgumentTypeError, ClockTypeError, InvalidJumpError, NotInitializedError
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

# Windows does not interrupt a wait for Ctrl-C.
_LONGEST_WAIT_S = 0.1 if sys.platform == "win32" else 86_400.0


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
        self._jumps.add(self)

    def unregister(self) -> None:
        """Call the callbacks no more; may be called twice."""
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
        self._changes.add(self)

    def unregister(self) -> None:
        """Call the callback no more; may be called twice."""
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
        self._jumps: _Handles[JumpHandle] = _Handles()
        self._changes: _Handles[TimeChangeHandle] = _Handles()
