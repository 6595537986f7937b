"""Errors of nodes and of their publishers, services and clients."""

from __future__ import annotations

from typing import Any

from zbot.errors import InvalidNodeNameError, WrongTypeError, ZbotError, shortened
from zbot.interfaces.message import call_text
from zbot.interfaces.python_class import type_name


def argument_order_error(call: str, arguments: str) -> WrongTypeError:
    """Return the error that a function was given the right arguments in the wrong order."""
    return WrongTypeError(
        f"the arguments of {call} are in the wrong order: write {call}({arguments})"
    )


class NodeNameError(InvalidNodeNameError):
    """A node was created without a name."""

    def __init__(self, value: object) -> None:
        self.value = value
        name = value if isinstance(value, str) else ""
        given = f"a node needs a name, as in super().__init__('my_node'), not {value!r}"
        super().__init__(name, given, 0)


class UnknownNodeError(ZbotError, LookupError, RuntimeError):
    """A graph query asks about a node that does not exist (rclpy's NodeNameNonExistentError)."""

    def __init__(self, name: str, known: list[str]) -> None:
        self.name, self.known = name, known
        super().__init__(f"there is no node {name}; the nodes are: {', '.join(known) or 'none'}")


class InvalidPeriodError(ZbotError, ValueError, RuntimeError):
    """A period or frequency is not a positive number (rclpy raises RuntimeError for timers)."""

    def __init__(self, what: str, value: object) -> None:
        self.what, self.value = what, value
        unit = "seconds" if "period" in what else "hertz"
        super().__init__(
            f"{what} must be a positive number of {unit}, not {value!r}{_advice(value)}"
        )


def _advice(value: object) -> str:
    """Return what to write in place of a value that stands for a number, or `""`."""
    if type(value).__name__ == "Duration":
        return f": write {value.nanoseconds / 1e9:g}"  # type: ignore[attr-defined] # our own class
    return ": write its .value" if type(value).__name__ == "Parameter" else ""


class UnsupportedEventTypeError(ZbotError, RuntimeError):
    """rclpy's error for events that a middleware does not support. zbot never raises it."""


def request_type_error(service: str, expected: type[Any], value: object) -> WrongTypeError:
    """Return the error that a service was called with something else than its request."""
    is_class = isinstance(value, type)
    advice = "Request(), with parentheses" if is_class else call_text(expected)
    return WrongTypeError(
        f"{service} takes a {type_name(expected)}, not {shortened(value)}; write {advice}"
    )


def response_type_error(service: str, expected: type[Any], value: object) -> WrongTypeError:
    """Return the error that a service's callback returned something else than its response."""
    advice = "does it end with `return response`?"
    if isinstance(value, type):
        advice = "write Response(), with parentheses"
    given = f"returned {shortened(value)}, not a {type_name(expected)}"
    return WrongTypeError(f"the callback of {service} {given}: {advice}")


class ServiceError(ZbotError, RuntimeError):
    """A service call failed: there was no server, or the server sent no valid response.

    Attributes:
        service: Full name of the service.
        kind: `no_server`, `server_gone`, `error`, or the class name of the callback's exception.
        message: The server's text, or zbot's own text, without the service's name.
    """

    def __init__(self, service: str, kind: str, message: str) -> None:
        self.service, self.kind, self.message = service, kind, message
        super().__init__(f"{service}: {message}")
