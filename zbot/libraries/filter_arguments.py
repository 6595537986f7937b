"""Checks of the arguments of message filters."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from zbot.errors import ArgumentTypeError, WrongTypeError, described
from zbot.executor.errors import WrongObjectError
from zbot.log import warn_once
from zbot.node.argument_check import is_class, is_name, is_number
from zbot.node.subscription import Subscription

if TYPE_CHECKING:
    from collections.abc import Callable


def callback_form(messages: int, others: int) -> str:
    """Return the arguments of a callback as an error writes them, e.g. `(message1, message2)`."""
    return f"({', '.join([*_numbered('message', messages), *_numbered('argument', others)])})"


def _numbered(name: str, count: int) -> list[str]:
    return [name] if count == 1 else [f"{name}{number}" for number in range(1, count + 1)]


def connected(call: str, source: Any, callback: Callable[..., Any], *args: Any) -> int:
    """Register a function of the filter `call` at its input. Return the connection's id.

    Raises:
        WrongObjectError: The input is not a filter.
    """
    if isinstance(source, type) or not hasattr(source, "registerCallback"):
        raise _not_a_filter_error(call, source)
    connection: int = source.registerCallback(callback, *args)
    return connection


def _not_a_filter_error(call: str, value: Any) -> WrongObjectError:
    given, arguments = described(value), "self, Image, 'camera'"
    if isinstance(value, Subscription):
        given = "the result of create_subscription()"
        arguments = f"self, {value.msg_type.__name__}, {value.topic_name!r}"
    return WrongObjectError(
        f"{call} needs a filter, not {given}: write message_filters.Subscriber({arguments})"
    )


def check_list(call: str, filters: Any) -> None:
    """Check that a synchronizer gets its filters in a list.

    Raises:
        WrongObjectError: The filters are not in a list.
    """
    if not isinstance(filters, Iterable):
        raise WrongObjectError(f"{call} needs its filters in a list: write {call}([a, b], ...)")


def check_number(argument: str, value: Any, unit: str) -> None:
    """Check that an argument is a number.

    Raises:
        ArgumentTypeError: It is not a number.
    """
    if not is_number(value):
        raise ArgumentTypeError(argument, f"a number of {unit}", value)


def check_size(argument: str, size: Any) -> None:
    """Check that the size of a queue is a number. Warn if the queue can keep no message.

    Raises:
        ArgumentTypeError: The size is not a number.
    """
    check_number(argument, size, "messages, e.g. 10")
    if size < 1:
        warn_once(f"{argument} is {size}, so a filter keeps no message: write e.g. {argument}=10")


def missing_argument_error(*given: Any) -> WrongTypeError:
    """Return the error that a subscriber lacks its node, the class of its messages or its topic."""
    kind = next((each.__name__ for each in given if is_class(each)), "")
    topic = next((each for each in given if is_name(each)), "")
    missing = ("node" if topic else "topic") if kind else "class of the messages"
    return WrongTypeError(
        f"Subscriber was not given its {missing}: "
        f"write Subscriber(self, {kind or 'Image'}, {topic or 'camera'!r})"
    )
