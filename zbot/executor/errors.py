"""Errors of executors, tasks, timers and clocks."""

from __future__ import annotations

from types import CoroutineType
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError, described, shortened
from zbot.process.signals import SignalExit

if TYPE_CHECKING:
    import inspect


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
            "this executor is already spinning: another thread, or the callback that calls this, "
            "runs in its spin(); use one executor for each thread, and `await` in a callback"
        )


class NotCallableError(ZbotError, TypeError):
    """A function was given something that is not callable in place of a callback.

    Attributes:
        call: The function, e.g. `create_timer`.
        value: What it was given.
        advice: What the value is, and what to write.
    """

    def __init__(self, call: str, value: object, advice: str) -> None:
        self.call, self.value, self.advice = call, value, advice
        given = "a coroutine" if isinstance(value, CoroutineType) else shortened(value)
        super().__init__(f"{call} was given {given}, {advice}")


class MethodOfClassError(ZbotError, TypeError):
    """A function was given a method of a class in place of a method of an object."""

    def __init__(self, call: str, method: Any) -> None:
        self.call, self.method = call, method
        super().__init__(
            f"{call} was given {method.__qualname__}, a method without its object: "
            f"write self.{method.__name__}"
        )


class CallbackSignatureError(ZbotError, RuntimeError):
    """A callback cannot be called with the arguments it would get.

    Attributes:
        call: The function that was given the callback, e.g. `create_subscription`.
        callback: The callback.
        forms: The possible arguments, e.g. `(message)` and `(message, info)`.
    """

    def __init__(
        self, call: str, callback: Any, signature: inspect.Signature, forms: tuple[str, ...]
    ) -> None:
        self.call, self.callback, self.forms = call, callback, forms
        name = getattr(callback, "__name__", type(callback).__name__)
        bound = ["self"] if hasattr(callback, "__self__") else []
        taken = ", ".join([*bound, *signature.parameters])
        wanted = ", ".join([*bound, *filter(None, [forms[0][1:-1]])])
        is_lambda = name == "<lambda>"
        right = f"lambda {wanted}".strip() if is_lambda else f"def {name}({wanted})"
        super().__init__(
            f"{call} needs a callback that takes {' or '.join(forms)}, but "
            f"{'the lambda' if is_lambda else name} takes ({taken}): write {right}:"
        )


class NodeArgumentError(ZbotError, TypeError, AttributeError):
    """A function was given something else in place of a node (rclpy: AttributeError)."""

    def __init__(self, call: str, value: Any) -> None:
        self.call, self.value = call, value
        text = f"{call} needs a node, e.g. Node('talker'), but was given {described(value)}"
        if isinstance(value, type) and hasattr(value, "create_publisher"):
            text += f"; write {value.__name__}() with parentheses to make a node"
        AttributeError.__init__(self, text, name="")  # so that Python suggests nothing


class ExecutorArgumentError(ZbotError, TypeError, AttributeError):
    """A function was given something else in place of an executor (rclpy: AttributeError)."""

    def __init__(self, value: object) -> None:
        self.value = value
        hint = f"; write timeout_sec={value!r}" if isinstance(value, (int, float)) else ""
        text = f"executor must be an executor, not {described(value)}{hint}"
        AttributeError.__init__(self, text, name="")


class RateInterruptedError(ZbotError):
    """The context's shutdown ended a rate's sleep (rclpy's ROSInterruptException)."""

    def __init__(self) -> None:
        super().__init__("interrupted by shutdown()")


class RateInterruptedBySignalError(SignalExit, RateInterruptedError):
    """`RateInterruptedError` for which Python prints no traceback."""


class TimerCancelledError(ZbotError, RuntimeError):
    """rclpy's error for a call of a canceled timer. Programs may catch it. zbot never raises it."""


class ConditionReachedException(ZbotError):  # noqa: N818 - rclpy's name
    """The condition of `wait_for_ready_callbacks` is true."""
