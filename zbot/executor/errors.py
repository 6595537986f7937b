"""Errors of executors, tasks, timers and clocks."""

from __future__ import annotations

from zbot.errors import ZbotError


class ClockTypeError(ZbotError, ValueError):
    """A clock got a time of another clock type."""

    def __init__(self, clock_type: str, given: str) -> None:
        self.clock_type, self.given = clock_type, given
        super().__init__(
            f"the time's clock type does not match this clock's: it is {given}, not {clock_type}; "
            "take the time from the same clock's now()"
        )


class InvalidJumpError(ZbotError, ValueError):
    """A jump threshold can never be reached, or a jump callback is missing or cannot be called."""

    def __init__(self, reason: str) -> None:
        self.reason = reason
        super().__init__(reason)


class ShutdownError(ZbotError, RuntimeError):
    """An object is used after its own shutdown()."""

    def __init__(self, what: str = "the executor") -> None:
        self.what = what
        super().__init__(f"{what} was shut down; create a new one")


class ExecutorBusyError(ZbotError, RuntimeError):
    """An executor is asked to spin while it is spinning."""

    def __init__(self) -> None:
        super().__init__(
            "this executor is already spinning: a callback cannot spin its own executor, "
            "use `await` in an `async def` callback instead"
        )


class CallbackSignatureError(ZbotError, RuntimeError):
    """A callback cannot be called with the arguments it would get."""

    def __init__(self, what: str, expected: str) -> None:
        self.what, self.expected = what, expected
        super().__init__(f"{what} must be callable with {expected}")


class RateInterruptedError(ZbotError):
    """The context's shutdown ended a rate's sleep (rclpy's ROSInterruptException)."""

    def __init__(self) -> None:
        super().__init__("interrupted by shutdown()")


class TimerCancelledError(ZbotError, RuntimeError):
    """rclpy's error for a call of a canceled timer. Programs may catch it. zbot never raises it."""


class ConditionReachedException(ZbotError):  # noqa: N818 - rclpy's name
    """The condition of `wait_for_ready_callbacks` is true."""
