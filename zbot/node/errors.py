"""Errors of nodes, and of the calls between them."""

from __future__ import annotations

from zbot.errors import InvalidNameError, InvalidNodeNameError, ZbotError, shortened


class AskedNameError(InvalidNameError):
    """A question about the graph names a topic or service that nothing can be called."""

    def __init__(self, fault: InvalidNameError) -> None:
        super().__init__(fault.name_type, fault.name, fault.error_msg, fault.invalid_index)
        self.args = (f"{self.name_type} {self.name!r} is invalid: {self.error_msg}",)


class MessageTypeError(ZbotError, TypeError):
    """A message of another type than the topic's was given."""

    def __init__(self, topic: str, expected: str, value: object) -> None:
        self.topic, self.expected, self.value = topic, expected, value
        super().__init__(
            f"{topic} carries {expected}, but publish() was given {type(value).__name__}: {value!r}"
        )


class NodeNameError(InvalidNodeNameError):
    """A node is created without a name."""

    def __init__(self, value: object) -> None:
        self.value = value
        name = value if isinstance(value, str) else ""
        given = f"a node needs a name, as in super().__init__('my_node'), not {value!r}"
        super().__init__(name, given, 0)


class UnknownNodeError(ZbotError, LookupError, RuntimeError):
    """A node is asked for that is not there (rclpy's NodeNameNonExistentError)."""

    def __init__(self, name: str, known: list[str]) -> None:
        self.name, self.known = name, known
        super().__init__(f"there is no node {name}; the nodes are: {', '.join(known) or 'none'}")


class InvalidPeriodError(ZbotError, ValueError, RuntimeError):
    """A period or frequency is no positive number (rclpy: RuntimeError for timers)."""

    def __init__(self, what: str, value: object) -> None:
        self.what, self.value = what, value
        super().__init__(f"{what} must be a positive number of seconds or hertz, not {value!r}")


class UnsupportedEventTypeError(ZbotError, RuntimeError):
    """rclpy's error for events that a middleware lacks, for programs that catch it."""


class RequestTypeError(ZbotError, TypeError):
    """A service was called with something else than its request."""

    def __init__(self, service: str, expected: str, value: object) -> None:
        self.service, self.expected, self.value = service, expected, value
        super().__init__(f"{service} takes a {expected}, not {shortened(value)}")


class ResponseTypeError(ZbotError, TypeError):
    """A service's callback returned something else than its response."""

    def __init__(self, service: str, expected: str, value: object) -> None:
        self.service, self.expected, self.value = service, expected, value
        hint = ": does it end with `return response`?" if value is None else ""
        super().__init__(
            f"the callback of {service} returned {shortened(value)}, not a {expected}{hint}"
        )


class ServiceError(ZbotError, RuntimeError):
    """A service call has no answer, or its server could not give one.

    Attributes:
        service: Full name of the service.
        kind: `no_server`, `server_gone`, `bad_reply`, or the class of the handler's exception.
        message: The sentence without the service's name; from the server where it sent one.
    """

    def __init__(self, service: str, kind: str, message: str) -> None:
        self.service, self.kind, self.message = service, kind, message
        super().__init__(f"{service}: {message}")
