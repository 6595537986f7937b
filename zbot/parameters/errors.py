"""Errors about a node's parameters, with rclpy's names."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from zbot.errors import (
    InvalidParameterError,
    ParameterError,
    SetupError,
    WrongValueError,
    ZbotError,
)
from zbot.errors.suggestion import question, similar_names

if TYPE_CHECKING:
    from collections.abc import Iterable

__all__ = [
    "InvalidParameterException",
    "InvalidParameterValueException",
    "InvalidQosOverridesError",
    "ParameterAlreadyDeclaredException",
    "ParameterDeclarationError",
    "ParameterException",
    "ParameterImmutableException",
    "ParameterListError",
    "ParameterNotDeclaredException",
    "ParameterUninitializedException",
    "UnknownCallbackError",
]

_DECIMAL_COMMA = re.compile(r"[-+]?[0-9]+,[0-9]+")
_NUMBER = re.compile(r"[-+]?\d+(\.\d+)?")

ParameterException = ParameterError
InvalidParameterException = InvalidParameterError


def decimal_comma(value: object, expected_type: str) -> str:
    """Return `; write 1.5, with a point` if a text such as `1,5` is given for a number."""
    is_number = expected_type.lower() in {"double", "integer"}
    if is_number and isinstance(value, str) and _DECIMAL_COMMA.fullmatch(value):
        return f"; write {value.replace(',', '.')}, with a point"
    return ""


def advice_for_override(value: object, expected_type: str) -> str:
    """Return what to write in a file in place of a value of another type, e.g. without quotes."""
    is_number = expected_type.lower() in {"double", "integer"}
    if is_number and isinstance(value, str) and _NUMBER.fullmatch(value):
        return f"; write {value}, without quotes"
    if expected_type.lower() == "string" and isinstance(value, (bool, int, float)):
        return "; put it into quotes, or write ParameterValue(..., value_type=str) in a launch file"
    return decimal_comma(value, expected_type)


class ParameterNotDeclaredException(ParameterError, LookupError):
    """A program used a parameter that the node has not declared.

    Attributes:
        suggestions: Declared names that are similar.
    """

    def __init__(
        self, parameters: str | list[str], known: Iterable[str] = (), advice: str = ""
    ) -> None:
        super().__init__("Invalid access to undeclared parameter(s)", parameters)
        self.suggestions = similar_names(str(self.parameters[0]), known) if self.parameters else ()
        self.args = (f"{self.args[0]}{question(self.suggestions, '; ') or advice}",)


class ParameterAlreadyDeclaredException(ParameterError, ValueError):
    """A parameter was declared a second time."""

    def __init__(self, parameters: str | list[str]) -> None:
        super().__init__("Parameter(s) already declared", parameters)


class InvalidParameterValueException(ParameterError, ValueError):
    """A parameter's descriptor or a callback of the node rejected a value."""

    def __init__(self, parameter: str, value: object, reason: str) -> None:
        self.value, self.reason = value, reason
        super().__init__(
            f"Invalid parameter value ({value}) for parameter. Reason: {reason}", parameter
        )


class ParameterImmutableException(ParameterError):
    """A program tried to change or undeclare a read-only parameter."""

    def __init__(self, parameter_name: str) -> None:
        super().__init__("Attempted to modify read-only parameter", parameter_name)


class ParameterUninitializedException(ParameterError):
    """A parameter was declared with only a type, and has no value yet."""

    def __init__(self, parameter_name: str) -> None:
        super().__init__(f"The parameter '{parameter_name}' is not initialized", parameter_name)
        advice = f"set it, for example with -p {parameter_name}:=..., or use get_parameter_or()"
        self.args = (f"{self.error_msg}: {advice}",)


class ParameterDeclarationError(ZbotError, ValueError):
    """A declaration is not consistent, e.g. the value and the type are both missing."""

    def __init__(self, parameter: str, reason: str) -> None:
        self.parameter, self.reason = parameter, reason
        super().__init__(f"cannot declare the parameter {parameter!r}: {reason}")


class ParameterListError(ZbotError, TypeError):
    """An element in a list of parameters or declarations has the wrong form."""

    def __init__(self, index: int, item: object, expected: str) -> None:
        self.index, self.item, self.expected = index, item, expected
        text = f"element {index} of the list must be {expected}, not {item!r}"
        if expected == "a Parameter" and isinstance(item, tuple) and len(item) == 2:
            text += f"; write Parameter({item[0]!r}, value={item[1]!r})"
        super().__init__(text)


class UnknownCallbackError(ZbotError, ValueError, RuntimeError):
    """A program tried to remove a parameter callback that was never added."""

    def __init__(self, callback: object) -> None:
        self.callback = callback
        super().__init__(f"{callback!r} is not one of the node's parameter callbacks")


class InvalidQosOverridesError(ZbotError):
    """A callback of the program rejected a QoS profile with its overrides."""

    def __init__(self, what: str, reason: str) -> None:
        self.what, self.reason = what, reason
        super().__init__(f"the QoS overrides of {what} are not valid: {reason}")


class ArgumentsError(SetupError, ValueError, RuntimeError):
    """Arguments after `--ros-args` are unknown or not valid."""

    def __init__(self, word: str | list[str], reason: str) -> None:
        self.word, self.reason = word, reason
        super().__init__(f"Failed to parse ROS arguments: {word!r}: {reason}")


class ParameterValueError(ZbotError, ValueError):
    """A text is not a value that a parameter can have."""

    def __init__(self, text: str, reason: str) -> None:
        self.text, self.reason = text, reason
        super().__init__(f"not a parameter's value: {text[:100]!r}: {reason}")


def parameter_answer_error(node: str, reason: str) -> WrongValueError:
    """Return the error that a node's answer about its parameters does not fit the request."""
    return WrongValueError(f"{node} gave a wrong answer about its parameters: {reason}")


class ParametersFileError(SetupError, ValueError, RuntimeError):
    """A parameter file cannot be read, or does not have ROS 2's format."""

    def __init__(self, path: str, reason: str) -> None:
        self.path, self.reason = path, reason
        super().__init__(f"cannot use the parameter file {path}: {reason}")


class ParametersFileNotFoundError(ParametersFileError, FileNotFoundError):
    """A parameter file does not exist."""
