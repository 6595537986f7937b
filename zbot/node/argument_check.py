"""Checks of the arguments of `create_publisher` and its siblings."""

from __future__ import annotations

from itertools import permutations
from types import FunctionType, MethodType
from typing import TYPE_CHECKING, Any

from zbot.errors import ArgumentTypeError, shortened
from zbot.node.errors import InvalidPeriodError, argument_order_error
from zbot.qos import QoSProfile

if TYPE_CHECKING:
    from collections.abc import Callable

    Kind = Callable[[Any], bool]

_LONGEST_PERIOD_S = 2**33


def is_class(value: object) -> bool:
    """Return whether a value can be the type of a topic, service or action."""
    return isinstance(value, type)


def is_name(value: object) -> bool:
    """Return whether a value can be a name."""
    return isinstance(value, str)


def is_number(value: object) -> bool:
    """Return whether a value is a number, also of numpy."""
    return hasattr(value, "__float__") and not isinstance(value, type)


def is_profile(value: object) -> bool:
    """Return whether a value can be the quality of service of a topic."""
    return isinstance(value, (QoSProfile, int)) and not isinstance(value, bool)


def is_node(value: object) -> bool:
    """Return whether a value can be a node."""
    return hasattr(value, "create_publisher") and not isinstance(value, type)


def check_order(call: str, *arguments: tuple[object, Kind]) -> None:
    """Check that the arguments of a call are not in the wrong order.

    Args:
        call: The called function.
        arguments: Each argument, and the function that tells whether it has the right kind.

    Raises:
        WrongTypeError: An argument has a wrong kind, but another order is right.
    """
    if all(is_right(value) for value, is_right in arguments):
        return
    values, kinds = zip(*arguments, strict=True)
    for order in permutations(values):
        if all(is_right(value) for is_right, value in zip(kinds, order, strict=True)):
            raise argument_order_error(call, ", ".join(map(_written, order)))


def _written(value: Any) -> str:
    """Return the text that a program would write for a value."""
    if isinstance(value, MethodType):
        return f"self.{value.__name__}"
    if isinstance(value, (type, FunctionType)) and value.__name__ != "<lambda>":
        return value.__name__
    if is_node(value):
        return "self"
    text = shortened(value)
    return type(value).__name__.lower() if text.startswith("<") else text


def check_object(argument: str, value: Any, kind: str, attribute: str) -> None:
    """Check that an argument is an object with an attribute.

    Raises:
        ArgumentTypeError: The argument has no such attribute, or is a class.
    """
    if isinstance(value, type):
        raise ArgumentTypeError(argument, f"{kind}, e.g. {value.__name__}()", value)
    if not hasattr(value, attribute):
        raise ArgumentTypeError(argument, kind, value)


def seconds(what: str, value: Any) -> float:
    """Return a period in seconds.

    Raises:
        InvalidPeriodError: The value is negative, too large or not a number.
    """
    if not is_number(value) or not 0 <= float(value) < _LONGEST_PERIOD_S:
        raise InvalidPeriodError(what, value)
    return float(value)
