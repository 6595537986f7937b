"""What can go wrong, as one tree of exceptions.

Each class also inherits the builtin that a stranger would catch. The constructor takes facts and
keeps them as attributes; the class writes the sentence: what is wrong, the offending value, and
what to do.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable


class ZbotError(Exception):
    """Root of everything that zbot raises on purpose."""


def nearest(name: str, known: Iterable[str], count: int = 3) -> tuple[str, ...]:
    """Up to `count` of the `known` names that `name` may be a misspelling of, best first."""
    from difflib import get_close_matches  # noqa: PLC0415 - 3 ms that only a mistake needs

    by_lower = {candidate.lower(): candidate for candidate in known}
    return tuple(by_lower[near] for near in get_close_matches(name.lower(), by_lower, count))


class ArgumentTypeError(ZbotError, TypeError):
    """A function was given a value of the wrong Python type, e.g. a number as a node's name."""

    def __init__(self, argument: str, expected: str, value: object) -> None:
        self.argument, self.expected, self.value = argument, expected, value
        super().__init__(f"{argument} must be {expected}, not {type(value).__name__}: {value!r}")


class InvalidNameError(ZbotError, ValueError):
    """A node, namespace, topic or service name breaks the ROS 2 grammar.

    Attributes:
        name_type: What the name names, e.g. `topic name`.
        name: The name as it was given.
        error_msg: The rule that it breaks.
        invalid_index: Index in `name` of the first character that breaks it.
    """

    def __init__(self, name_type: str, name: str, error_msg: str, invalid_index: int) -> None:
        self.name_type, self.name = name_type, name
        self.error_msg, self.invalid_index = error_msg, invalid_index
        # repr may escape characters: count what it prints before the invalid one.
        column = len(repr(name[:invalid_index])) - 1
        super().__init__(f"Invalid {name_type}: {error_msg}:\n  {name!r}\n  {' ' * column}^")


class InvalidNodeNameError(InvalidNameError):
    """A node's name is empty, too long or has a character that names may not have."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("node name", name, error_msg, invalid_index)


class InvalidNamespaceError(InvalidNameError):
    """A namespace is not absolute or breaks the grammar."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("namespace", name, error_msg, invalid_index)


class InvalidTopicNameError(InvalidNameError):
    """A topic's name breaks the grammar, before or after it was expanded."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("topic name", name, error_msg, invalid_index)


class InvalidServiceNameError(InvalidNameError):
    """A service's name breaks the grammar, before or after it was expanded."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("service name", name, error_msg, invalid_index)


class AskedNameError(InvalidNameError):
    """A question about the graph names a topic or service that nothing can be called."""

    def __init__(self, fault: InvalidNameError) -> None:
        super().__init__(fault.name_type, fault.name, fault.error_msg, fault.invalid_index)
        self.args = (f"{self.name_type} {self.name!r} is invalid: {self.error_msg}",)


class ParameterError(ZbotError):
    """Root of what can go wrong with a node's parameters.

    Attributes:
        error_msg: What is wrong.
        parameters: The names concerned.
    """

    def __init__(self, error_msg: str, parameters: str | list[str]) -> None:
        self.error_msg = error_msg
        self.parameters = [parameters] if isinstance(parameters, str) else list(parameters)
        super().__init__(f"{error_msg}: {', '.join(map(repr, self.parameters))}")


class InvalidParameterError(ParameterError, ValueError):
    """A parameter's name is not acceptable, e.g. empty."""

    def __init__(self, parameter_name: str) -> None:
        super().__init__("Invalid parameter name", parameter_name)


class ClockMismatchError(ZbotError, TypeError):
    """Times of two kinds of clock were compared or subtracted."""

    def __init__(self, first: str, second: str) -> None:
        self.first, self.second = first, second
        super().__init__(
            f"cannot compare or subtract times of different clock types ({first} and {second}): "
            "take both from the same clock"
        )


class InvalidSeverityError(ZbotError, ValueError, RuntimeError):
    """A log severity is none of the five (rclpy: ValueError for numbers, RuntimeError for text)."""

    def __init__(self, severity: object) -> None:
        self.severity = severity
        super().__init__(
            f"{severity!r} is not a log severity: use DEBUG (10), INFO (20), WARN (30), "
            "ERROR (40) or FATAL (50)"
        )


class LogOptionError(ZbotError, TypeError):
    """A log call has an option that does not exist, or lacks the one that another needs."""

    def __init__(self, option: str, reason: str) -> None:
        self.option, self.reason = option, reason
        super().__init__(f"log parameter {option!r} {reason}")


class LogCallChangedError(ZbotError, ValueError):
    """One line of a program makes a different log call than before.

    Options such as `once` are remembered for each place in the source, so a place has to stay what
    it was, as in rclpy.

    Attributes:
        what: What changed, e.g. `severity`.
        place: File and line of the call.
    """

    def __init__(self, what: str, place: str) -> None:
        self.what, self.place = what, place
        super().__init__(
            f"a log call's {what} cannot be changed between calls: "
            f"write one call for each ({place})"
        )


class NotAClockError(ZbotError, ValueError):
    """Something that is no clock was given where one is needed."""

    def __init__(self, argument: str, value: object) -> None:
        self.argument, self.value = argument, value
        super().__init__(
            f"{argument} must be a Clock instance, for example node.get_clock(), not {value!r}"
        )


class ClockTypeError(ZbotError, ValueError):
    """A clock was given a time of another kind of clock."""

    def __init__(self, clock_type: str, given: str) -> None:
        self.clock_type, self.given = clock_type, given
        super().__init__(
            f"the time's clock type does not match this clock's: it is {given}, not {clock_type}; "
            "take it from the same clock's now()"
        )


class InvalidJumpError(ZbotError, ValueError):
    """A request to be told of time jumps can never be met, or names nothing to call."""

    def __init__(self, reason: str) -> None:
        self.reason = reason
        super().__init__(reason)


class NegativeTimeError(ZbotError, ValueError):
    """A point in time would lie before its clock's zero."""

    def __init__(self, value: float) -> None:
        self.value = value
        super().__init__(f"a time must not be negative: {value!r}")


class TimeOverflowError(ZbotError, OverflowError):
    """A time or duration is not finite or does not fit in 64 bits of nanoseconds."""

    def __init__(self, what: str, seconds: float, nanoseconds: float) -> None:
        self.what, self.seconds, self.nanoseconds = what, seconds, nanoseconds
        value = f"{seconds!r} s" if seconds else f"{nanoseconds!r} ns"
        super().__init__(f"{what} out of range: {value} (the limit is 292 years)")


class SetupError(ZbotError):
    """The surroundings of a program are wrong, not its code: no line of it is worth showing."""


class DomainIdError(SetupError, ValueError, RuntimeError):
    """A domain id is no integer in range."""

    def __init__(self, source: str, value: object, maximum: int) -> None:
        self.source, self.value, self.maximum = source, value, maximum
        super().__init__(
            f"{source} is {value!r}, but a domain is a whole number from 0 to {maximum}: "
            f"set it to one, for example {source}=7"
        )


class DiscoveryRangeError(SetupError, ValueError):
    """A discovery range variable holds an unknown word."""

    def __init__(self, source: str, value: str) -> None:
        self.source, self.value = source, value
        super().__init__(f"{source} is {value!r}: use LOCALHOST, SUBNET or OFF")


class PortError(SetupError, ValueError):
    """A variable that should hold a TCP port holds something else."""

    def __init__(self, source: str, value: str) -> None:
        self.source, self.value = source, value
        super().__init__(f"{source} is {value!r}, but a port is a number from 1 to 65535")


class ConfigError(SetupError, ValueError):
    """A Zenoh configuration file cannot be read or understood."""

    def __init__(self, source: str, reason: str) -> None:
        self.source, self.reason = source, reason
        # Zenoh adds the place in its own source code, which helps nobody here.
        told = " ".join(reason.split(" at /", maxsplit=1)[0].split())
        super().__init__(f"cannot use the Zenoh configuration {source}: {told}")


class SessionError(SetupError, OSError):
    """Zenoh could not open a session."""

    def __init__(self, what: str, reason: str) -> None:
        self.what, self.reason = what, reason
        super().__init__(
            f"cannot open {what}: {' '.join(reason.split(' at /', maxsplit=1)[0].split())}"
        )


class NotInitializedError(ZbotError, RuntimeError):
    """Something needs a context that is initialised and not yet shut down."""

    def __init__(self, what: str = "this") -> None:
        self.what = what
        super().__init__(f"{what} needs zbot.init() first (and no shutdown() since)")


class InvalidHandleError(ZbotError, RuntimeError):
    """An object is used after it, or its node, was destroyed."""

    def __init__(self, what: str = "the object") -> None:
        self.what = what
        super().__init__(f"{what} was destroyed and cannot be used any more")


class MessageTypeError(ZbotError, TypeError):
    """A message of another type than the topic's was given."""

    def __init__(self, topic: str, expected: str, value: object) -> None:
        self.topic, self.expected, self.value = topic, expected, value
        super().__init__(
            f"{topic} carries {expected}, but publish() was given {type(value).__name__}: {value!r}"
        )


class ShutdownError(ZbotError, RuntimeError):
    """Something is used after its own shutdown()."""

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


class InvalidQoSProfileError(ZbotError, ValueError):
    """A quality of service profile lacks a policy or has one that does not exist."""

    def __init__(self, reason: str) -> None:
        self.reason = reason
        super().__init__(f"Invalid QoSProfile: {reason}")


class QoSArgumentError(ZbotError, TypeError):
    """Neither a quality of service profile nor the depth of a queue was given."""

    def __init__(self, value: object) -> None:
        self.value = value
        super().__init__(
            "Expected QoSProfile or int, the depth of a queue, but received "
            f"{type(value).__name__}: {value!r}"
        )


class UnknownQoSKeyError(ZbotError, KeyError):
    """A short key names no policy value or profile, e.g. `relaible`."""

    def __init__(self, kind: str, key: str, known: list[str]) -> None:
        self.kind, self.key, self.known = kind, key, known
        super().__init__(f"{kind} has no {key!r}: use one of {', '.join(known)}")

    def __str__(self) -> str:
        # KeyError would print the sentence as a quoted key.
        return str(self.args[0])


class ContextInitializedError(ZbotError, RuntimeError):
    """A context is initialised a second time."""

    def __init__(self) -> None:
        super().__init__(
            "Context.init() must only be called once: call shutdown() before another init()"
        )


class InterfaceSyntaxError(ZbotError, ValueError):
    """A .msg, .srv or .action definition breaks the ROS 2 grammar.

    Attributes:
        file: The definition's file, or its type name when it has none.
        line: Line number from 1, or 0 when the definition as a whole is wrong.
        reason: The rule that it breaks, and what to write instead.
    """

    def __init__(self, file: str, line: int, source: str, reason: str) -> None:
        self.file, self.line, self.source, self.reason = file, line, source, reason
        where = f"{file}:{line}" if line else file
        quoted = f"\n  {source.strip()}" if source.strip() else ""
        super().__init__(f"{where}: {reason}{quoted}")


class UnknownPackageError(ZbotError, ModuleNotFoundError, LookupError):
    """No package of that name holds message, service or action definitions here."""

    def __init__(self, package: str, suggestions: tuple[str, ...] = ()) -> None:
        self.package, self.suggestions = package, suggestions
        super().__init__(f"Unknown package {package!r}{_did_you_mean(suggestions)}")


class UnknownInterfaceError(ZbotError, AttributeError, LookupError):
    """A known package has no message, service or action of that name."""

    def __init__(self, name: str, suggestions: tuple[str, ...] = ()) -> None:
        self.name, self.suggestions = name, suggestions
        super().__init__(f"Unknown interface {name!r}{_did_you_mean(suggestions)}")


class FieldTypeError(ZbotError, TypeError, AssertionError):
    """A message's field was given a value of the wrong Python type; ROS 2's classes assert it.

    Attributes:
        type_name: The message, e.g. `geometry_msgs/msg/Vector3`.
        field: The field's name, with an index where one element is wrong: `ranges[3]`.
        expected: What belongs there.
        value: What was given.
    """

    def __init__(self, type_name: str, field: str, expected: str, value: object) -> None:
        self.type_name, self.field, self.expected, self.value = type_name, field, expected, value
        given = f"{type(value).__name__}: {_shortened(value)}"
        super().__init__(f"field {field!r} of {type_name} must be {expected}, not {given}")


class FieldValueError(ZbotError, ValueError, AssertionError):
    """A message's field was given a value of the right type that it cannot hold.

    The attributes are those of `FieldTypeError`.
    """

    def __init__(self, type_name: str, field: str, expected: str, value: object) -> None:
        self.type_name, self.field, self.expected, self.value = type_name, field, expected, value
        given = _shortened(value)
        super().__init__(f"field {field!r} of {type_name} must be {expected}, not {given}")


class UnknownFieldError(ZbotError, TypeError, AssertionError):
    """A message was constructed with a field that its type does not have."""

    def __init__(self, type_name: str, field: str, fields: tuple[str, ...]) -> None:
        self.type_name, self.field, self.fields = type_name, field, fields
        near = nearest(field, fields, 1)
        hint = f"; did you mean {near[0]!r}?" if near else f"; it has {', '.join(fields) or 'none'}"
        super().__init__(f"{type_name} has no field {field!r}{hint}")


class PositionalFieldError(ZbotError, TypeError):
    """A message was constructed with values that do not say which field they are for."""

    def __init__(self, type_name: str, fields: tuple[str, ...]) -> None:
        self.type_name, self.fields = type_name, fields
        short = type_name.rpartition("/")[2]
        example = f"{fields[0]}=..." if fields else ""
        super().__init__(f"name the fields of {type_name}: {short}({example})")


class NotAMessageTypeError(ZbotError, TypeError, AttributeError):
    """A class was used as a message, service or action type that is none, or cannot be one.

    rclpy misses an attribute in such a class, and programs catch that.
    """

    def __init__(self, given: object, reason: str) -> None:
        self.given, self.reason = given, reason
        name = given.__qualname__ if isinstance(given, type) else repr(given)
        super().__init__(f"{name} cannot be used as an interface type: {reason}")


class InterfaceKindError(NotAMessageTypeError, RuntimeError):
    """A class of another kind was used: a service where a message belongs, or the like."""

    def __init__(self, given: object, expected: str) -> None:
        super().__init__(given, f"it is not {expected}")
        self.expected = expected


class TokenError(ZbotError, ValueError):
    """A liveliness key is no token of a zbot node, e.g. because another program declared it."""

    def __init__(self, key: str, reason: str) -> None:
        self.key, self.reason = key, reason
        super().__init__(f"not a liveliness token: {key[:200]!r}: {reason}")


class CallbackSignatureError(ZbotError, RuntimeError):
    """A callback cannot be called with the arguments it would get."""

    def __init__(self, what: str, expected: str) -> None:
        self.what, self.expected = what, expected
        super().__init__(f"{what} must be callable with {expected}")


class RateInterruptedError(ZbotError):
    """A rate's sleep was ended by the context's shutdown (rclpy's ROSInterruptException)."""

    def __init__(self) -> None:
        super().__init__("interrupted by shutdown()")


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


class TimerCancelledError(ZbotError, RuntimeError):
    """rclpy's error for calling a canceled timer, for programs that catch it."""


class UnsupportedEventTypeError(ZbotError, RuntimeError):
    """rclpy's error for events that a middleware lacks, for programs that catch it."""


class CodecError(ZbotError, ValueError):
    """A message cannot become bytes, or bytes cannot become a message of the type expected.

    Attributes:
        action: `encode` or `decode`.
        type_name: The type, e.g. `sensor_msgs/msg/Image`.
        field: Path of the field concerned, e.g. `header.stamp.sec`; empty if it is no single one.
        reason: What is wrong.
    """

    def __init__(self, action: str, type_name: str, field: str, reason: str) -> None:
        self.action, self.type_name, self.field, self.reason = action, type_name, field, reason
        where = f"field {field!r}: " if field else ""
        super().__init__(f"cannot {action} {type_name}: {where}{reason}")


class InterfaceConflictError(ZbotError, ValueError):
    """A definition came from elsewhere under a name that has another definition here."""

    def __init__(self, name: str) -> None:
        self.name = name
        super().__init__(
            f"{name} is defined differently here: bring both machines to the same definition"
        )


class RequestTypeError(ZbotError, TypeError):
    """A service was called with something else than its request."""

    def __init__(self, service: str, expected: str, value: object) -> None:
        self.service, self.expected, self.value = service, expected, value
        super().__init__(f"{service} takes a {expected}, not {_shortened(value)}")


class ResponseTypeError(ZbotError, TypeError):
    """A service's callback returned something else than its response."""

    def __init__(self, service: str, expected: str, value: object) -> None:
        self.service, self.expected, self.value = service, expected, value
        hint = ": does it end with `return response`?" if value is None else ""
        super().__init__(
            f"the callback of {service} returned {_shortened(value)}, not a {expected}{hint}"
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


def _did_you_mean(suggestions: tuple[str, ...]) -> str:
    return f"; did you mean {' or '.join(map(repr, suggestions))}?" if suggestions else ""


def _shortened(value: object, limit: int = 80) -> str:
    text = repr(value)
    return text if len(text) <= limit else f"{text[: limit - 3]}..."


class ArgumentsError(ZbotError, ValueError, RuntimeError):
    """A word after `--ros-args` is not understood, or several words are none of its flags."""

    def __init__(self, word: str | list[str], reason: str) -> None:
        self.word, self.reason = word, reason
        super().__init__(f"Failed to parse ROS arguments: {word!r}: {reason}")


class ParameterValueError(ZbotError, ValueError):
    """A text is no value that a parameter can have."""

    def __init__(self, text: str, reason: str) -> None:
        self.text, self.reason = text, reason
        super().__init__(f"not a parameter's value: {text[:100]!r}: {reason}")


class ParametersFileError(SetupError, ValueError, RuntimeError):
    """A parameter file cannot be read or has another form than ROS 2 asks for."""

    def __init__(self, path: str, reason: str) -> None:
        self.path, self.reason = path, reason
        super().__init__(f"cannot use the parameter file {path}: {reason}")


class ParametersFileNotFoundError(ParametersFileError, FileNotFoundError):
    """There is no such parameter file."""


class ExternalShutdownException(ZbotError):  # noqa: N818 - rclpy's name
    """The context was shut down, by a signal or another thread, while an executor was waiting."""


class ConditionReachedException(ZbotError):  # noqa: N818 - rclpy's name
    """What an executor was to wait for is there."""
