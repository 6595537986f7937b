"""Exceptions that several parts of zbot raise. All are subclasses of `ZbotError`.

Most classes also inherit the builtin exception that fits, e.g. `ValueError`. A constructor keeps
its arguments as attributes and writes the message. The message says what is wrong, what the value
is and what to do.
"""

from __future__ import annotations

import sys


class ZbotError(Exception):
    """Root of all exceptions that zbot raises on purpose, except `ExternalShutdownException`.

    Attributes:
        hint: What the user can do. The command prints it below the message. It is empty if there
            is no advice.
    """

    hint: str = ""

    def __init__(self, *args: object, hint: str | None = "") -> None:
        if hint:
            self.hint = hint
        super().__init__(*args)


def shortened(value: object, limit: int = 80) -> str:
    """Return at most `limit` characters of the `repr` of a value. A class is told by its name."""
    if isinstance(value, type):
        return f"the class {value.__name__}"
    try:
        text = repr(value)
    except ValueError:  # Python writes no number with more than 4300 digits
        text = "a value with a number of thousands of digits"
    return text if len(text) <= limit else f"{text[: limit - 3]}..."


def counted(number: int, noun: str) -> str:
    """Return a number with its noun, e.g. `1 message` or `2 messages`."""
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def described(value: object) -> str:
    """Return the type and value of an argument, or what it is if it is a class or a function."""
    if value is None or isinstance(value, type):
        return shortened(value)
    name = getattr(value, "__name__", "")
    if name and callable(value):
        return f"the function {name}"
    return f"{type(value).__name__}: {shortened(value)}"


class ArgumentTypeError(ZbotError, TypeError):
    """A function was given a value of the wrong Python type, e.g. a number as a node's name."""

    def __init__(self, argument: str, expected: str, value: object) -> None:
        self.argument, self.expected, self.value = argument, expected, value
        super().__init__(f"{argument} must be {expected}, not {described(value)}")


class WrongTypeError(ZbotError, TypeError):
    """A value has the wrong Python type, or an object of the wrong class was used."""


class WrongValueError(ZbotError, ValueError):
    """A value of the right type is not allowed, or does not fit another value."""


class WrongStateError(ZbotError, RuntimeError):
    """An operation is not possible now, or not with the given objects."""


class InvalidNameError(ZbotError, ValueError):
    """A node, namespace, topic or service name breaks the ROS 2 grammar.

    Attributes:
        name_type: The kind of name, e.g. `topic name`.
        name: The name as it was given.
        error_msg: The rule that the name breaks.
        invalid_index: Index in `name` of the first invalid character.
    """

    def __init__(self, name_type: str, name: str, error_msg: str, invalid_index: int) -> None:
        self.name_type, self.name = name_type, name
        self.error_msg, self.invalid_index = error_msg, invalid_index
        # repr may escape characters, so the column is counted in the printed text.
        column = len(repr(name[:invalid_index])) - 1
        super().__init__(f"Invalid {name_type}: {error_msg}:\n  {name!r}\n  {' ' * column}^")


class InvalidNodeNameError(InvalidNameError):
    """A node's name is empty, too long or has a forbidden character."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("node name", name, error_msg, invalid_index)


class InvalidNamespaceError(InvalidNameError):
    """A namespace is not absolute or breaks the grammar."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("namespace", name, error_msg, invalid_index)


class InvalidTopicNameError(InvalidNameError):
    """A topic's name breaks the grammar, before or after its expansion."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("topic name", name, error_msg, invalid_index)


class InvalidServiceNameError(InvalidNameError):
    """A service's name breaks the grammar, before or after its expansion."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("service name", name, error_msg, invalid_index)


class ParameterError(ZbotError):
    """Root of the errors about a node's parameters.

    Attributes:
        error_msg: The problem.
        parameters: Names of the parameters that have the problem.
    """

    def __init__(self, error_msg: str, parameters: str | list[str]) -> None:
        self.error_msg = error_msg
        self.parameters = [parameters] if isinstance(parameters, str) else list(parameters)
        super().__init__(f"{error_msg}: {', '.join(map(repr, self.parameters))}")


class InvalidParameterError(ParameterError, ValueError):
    """A parameter's name is invalid, e.g. empty."""

    def __init__(self, parameter_name: str) -> None:
        super().__init__("Invalid parameter name", parameter_name)


def negative_time_error(value: float) -> WrongValueError:
    """Return the error that a point in time is negative."""
    return WrongValueError(f"a time must not be negative: {value!r}")


class TimeOverflowError(ZbotError, OverflowError, ValueError):
    """A time or duration is not finite or does not fit in 64 bits of nanoseconds.

    The error is also a ValueError, because rclpy raises ValueError for NaN.
    """

    def __init__(self, what: str, seconds: float, nanoseconds: float) -> None:
        self.what, self.seconds, self.nanoseconds = what, seconds, nanoseconds
        value = f"{seconds!r} s" if seconds else f"{nanoseconds!r} ns"
        super().__init__(f"{what} out of range: {value} (the limit is 292 years)")


class SetupError(ZbotError):
    """The environment of a program is wrong. A traceback of the code would not help."""


class MissingPackageError(SetupError, ModuleNotFoundError):
    """A package that a part of zbot needs is not installed.

    Attributes:
        name: The missing package.
    """

    def __init__(self, user: str, name: str, extra: str) -> None:
        from zbot.errors.installation import pip_install  # noqa: PLC0415 - only for this error

        super().__init__(f"{user} needs {name}: {pip_install(f'zbot[{extra}]')}")
        self.name = name


def require_numpy(user: str) -> None:
    """Check that numpy is installed, without importing it.

    Args:
        user: The module that needs numpy, e.g. `cv_bridge`.

    Raises:
        MissingPackageError: It is not installed.
    """
    if "numpy" in sys.modules:
        return
    from importlib.util import find_spec  # noqa: PLC0415 - seldom needed

    if find_spec("numpy") is None:
        raise MissingPackageError(user, "numpy", "numpy")


def library_name() -> str:
    """Return the name of the library that the program uses, `rclpy` or `zbot`."""
    return "rclpy" if "rclpy" in sys.modules else "zbot"


class NotInitializedError(ZbotError, RuntimeError):
    """An operation needs a context that is initialised and not yet shut down."""

    def __init__(self, what: str = "this") -> None:
        self.what = what
        super().__init__(self._sentence(f"{library_name()}.init()"))

    def _sentence(self, init: str) -> str:
        return f"{self.what} needs {init} first (and no shutdown() after it)"


class ForkedProcessError(NotInitializedError):
    """A forked child process uses a node or another object of its parent process."""

    def _sentence(self, init: str) -> str:
        return (
            f"{self.what} cannot be used in this process, which is a fork of the process that has "
            f"the node: call {init} here and create a node here, or start this process with "
            "multiprocessing.get_context('spawn')"
        )


class InvalidHandleError(ZbotError, RuntimeError):
    """An object was used after the object or its node was destroyed."""

    def __init__(self, what: str = "the object") -> None:
        self.what = what
        super().__init__(f"{what} was destroyed and cannot be used any more")


class InvalidQoSProfileError(ZbotError, ValueError):
    """A QoS profile lacks a policy or has a policy value that does not exist."""

    def __init__(self, reason: str) -> None:
        self.reason = reason
        super().__init__(f"Invalid QoSProfile: {reason}")


def qos_argument_error(value: object) -> WrongTypeError:
    """Return the error that a value is not a QoS profile and not the depth of a queue."""
    preset = hasattr(getattr(value, "value", None), "depth")
    advice = f"{value}.value" if preset else "the depth, e.g. 10"
    return WrongTypeError(
        "Expected QoSProfile or int, the depth of a queue, but received "
        f"{described(value)}; write {advice}"
    )


class UnknownQoSKeyError(ZbotError, KeyError):
    """No policy value or profile has the given short key, e.g. `relaible`."""

    def __init__(self, kind: str, key: str, known: list[str]) -> None:
        self.kind, self.key, self.known = kind, key, known
        super().__init__(f"{kind} has no {key!r}: use one of {', '.join(known)}")

    def __str__(self) -> str:
        # KeyError would print the message in quotes, like a key.
        return str(self.args[0])


class ExternalShutdownException(Exception):  # noqa: N818 - rclpy's name
    """A signal or another thread shut down the context while an executor was waiting.

    It is not a `ZbotError`, so that code that handles errors does not stop the end of the program.
    """
