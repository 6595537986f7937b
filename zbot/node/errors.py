"""Errors of nodes and of their publishers, services and clients."""

from __future__ import annotations

from zbot.errors import InvalidNameError, InvalidNodeNameError, ZbotError, shortened


class AskedNameError(InvalidNameError):
    """A graph query has an invalid topic or service name."""

    def __init__(self, fault: InvalidNameError) -> None:
        super().__init__(fault.name_type, fault.name, fault.error_msg, fault.invalid_index)
        self.args = (f"{self.name_type} {self.name!r} is invalid: {self.error_msg}",)


class ArgumentOrderError(ZbotError, TypeError):
    """A function was given the right arguments in the wrong order."""

    def __init__(self, call: str, arguments: str) -> None:
        self.call, self.arguments = call, arguments
        super().__init__(
            f"the arguments of {call} are in the wrong order: write {call}({arguments})"
        )


class MessageTypeError(ZbotError, TypeError):
    """`publish` was called with a message that does not have the topic's type."""

    def __init__(self, topic: str, expected: str, value: object) -> None:
        self.topic, self.expected, self.value = topic, expected, value
        super().__init__(
            f"{topic} carries {expected}, but publish() was given {type(value).__name__}: {value!r}"
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
        super().__init__(f"{what} must be a positive number of seconds or hertz, not {value!r}")


class UnsupportedEventTypeError(ZbotError, RuntimeError):
    """rclpy's error for events that a middleware does not support. zbot never raises it."""


class RequestTypeError(ZbotError, TypeError):
    """A service was called with an object that is not a request of this service."""

    def __init__(self, service: str, expected: str, value: object) -> None:
        self.service, self.expected, self.value = service, expected, value
        super().__init__(f"{service} takes a {expected}, not {shortened(value)}")


class ResponseTypeError(ZbotError, TypeError):
    """A service's callback returned an object that is not a response of this service."""

    def __init__(self, service: str, expected: str, value: object) -> None:
        self.service, self.expected, self.value = service, expected, value
        hint = ": does it end with `return response`?" if value is None else ""
        super().__init__(
            f"the callback of {service} returned {shortened(value)}, not a {expected}{hint}"
        )


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
