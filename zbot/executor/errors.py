"""Errors of executors, tasks, timers and clocks."""

from __future__ import annotations

from types import CoroutineType, MethodType
from typing import TYPE_CHECKING, Any

from zbot.errors import (
    WrongStateError,
    WrongTypeError,
    WrongValueError,
    ZbotError,
    described,
    shortened,
)
from zbot.process.signals import SignalExit

if TYPE_CHECKING:
    import inspect


def clock_type_error(clock_type: str, given: str) -> WrongValueError:
    """Return the error that a clock got a time of another clock type."""
    return WrongValueError(
        f"the time's clock type does not match this clock's: it is {given}, not {clock_type}; "
        "take the time from the same clock's now()"
    )


class ShutdownError(ZbotError, RuntimeError):
    """An object is used after its own shutdown()."""

    def __init__(self, what: str = "the executor") -> None:
        self.what = what
        super().__init__(f"{what} was shut down; create a new one")


def not_callable_error(call: str, value: object, advice: str) -> WrongTypeError:
    """Return the error that a function was given something else in place of a callback."""
    given = "a coroutine" if isinstance(value, CoroutineType) else shortened(value)
    return WrongTypeError(f"{call} was given {given}, {advice}")


def callback_signature_error(
    call: str, callback: Any, signature: inspect.Signature, forms: tuple[str, ...]
) -> WrongStateError:
    """Return the error that a callback cannot be called with the arguments it would get.

    Args:
        call: The function of the program's call.
        callback: What the program gave.
        signature: The parameters that the program wrote, of a method with `self`.
        forms: The arguments that the callback would get.
    """
    name = getattr(callback, "__name__", type(callback).__name__)
    owner = callback.__self__ if isinstance(callback, MethodType) else None
    bound = ["cls" if isinstance(owner, type) else "self"] if owner is not None else []
    taken = ", ".join(signature.parameters)
    wanted = ", ".join([*bound, *filter(None, [forms[0][1:-1]])])
    is_lambda = name == "<lambda>"
    right = f"lambda {wanted}".strip() if is_lambda else f"def {name}({wanted})"
    return WrongStateError(
        f"{call} needs a callback that takes {' or '.join(forms)}, but "
        f"{'the lambda' if is_lambda else name} takes ({taken}): write {right}:"
    )


class WrongObjectError(ZbotError, TypeError, AttributeError):
    """A function was given something else than a node or an executor (rclpy: AttributeError)."""

    def __init__(self, text: str) -> None:
        AttributeError.__init__(self, text, name="")  # Python would look for a similar name


_SEVERAL_NODES = (
    "; for several nodes, write executor = SingleThreadedExecutor(), executor.add_node(node) "
    "for each node, and executor.spin()"
)


def not_a_node_error(call: str, value: Any) -> WrongObjectError:
    """Return the error that a function was given something else in place of a node."""
    text = f"{call} needs a node, e.g. Node('talker'), but was given {described(value)}"
    if isinstance(value, type) and hasattr(value, "create_publisher"):
        text += f"; write {value.__name__}() with parentheses to make a node"
    if isinstance(value, (list, tuple)):
        text += _SEVERAL_NODES
    return WrongObjectError(text)


def not_an_executor_error(value: object) -> WrongObjectError:
    """Return the error that a function was given something else in place of an executor."""
    hint = f"; write timeout_sec={value!r}" if isinstance(value, (int, float)) else ""
    if hasattr(value, "create_publisher"):
        hint = _SEVERAL_NODES
    return WrongObjectError(f"executor must be an executor, not {described(value)}{hint}")


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
