"""Errors about definitions, and about values that a field does not accept."""

from __future__ import annotations

import re

from zbot.errors import WrongTypeError, ZbotError, described, shortened
from zbot.errors.suggestion import did_you_mean, question

_NUMBER = re.compile(r"\s*[-+]?\d+([.,]\d+)?\s*")


class InterfaceSyntaxError(ZbotError, ValueError):
    """A .msg, .srv or .action definition breaks the ROS 2 grammar.

    Attributes:
        file: The definition's file, or the type name if there is no file.
        line: Line number from 1, or 0 when the definition as a whole is wrong.
        reason: The rule that the definition breaks, and what to write.
    """

    def __init__(self, file: str, line: int, source: str, reason: str) -> None:
        self.file, self.line, self.source, self.reason = file, line, source, reason
        where = f"{file}:{line}" if line else file
        quoted = f"\n  {source.strip()}" if source.strip() else ""
        super().__init__(f"{where}: {reason}{quoted}")


class DefinitionLimitError(InterfaceSyntaxError):
    """A definition from another machine is too large to use: its messages could fill the memory.

    Attributes:
        type_name: Full name of the type.
    """

    def __init__(self, type_name: str, reason: str) -> None:
        self.type_name = type_name
        sentence = f"zbot does not use this definition from another machine, because {reason}"
        super().__init__(type_name, 0, "", sentence)


class UnknownPackageError(ZbotError, ModuleNotFoundError, LookupError):
    """No package with that name has message, service or action definitions here."""

    def __init__(self, package: str, suggestions: tuple[str, ...] = ()) -> None:
        self.package, self.suggestions = package, suggestions
        super().__init__(f"Unknown package {package!r}{question(suggestions, '; ')}")


class InterfaceImportError(ZbotError, ModuleNotFoundError):
    """A program imports a package of definitions, or a module of one, that does not exist here."""

    def __init__(self, package: str, text: str) -> None:
        super().__init__(text)
        # With the module's full name, `from package import name` would drop this error.
        self.name = package


class UnknownInterfaceError(ZbotError, AttributeError, LookupError):
    """A known package has no message, service or action with that name."""

    def __init__(self, name: str, suggestions: tuple[str, ...] = ()) -> None:
        self.name, self.suggestions = name, suggestions
        super().__init__(f"Unknown interface {name!r}{question(suggestions, '; ')}")


def _hint(expected: str, value: object) -> str:
    """Return what to write in place of a value of a wrong type, if that is known."""
    if hasattr(value, "to_msg") and expected.endswith(("/Time", "/Duration")):
        return "; write .to_msg() after it"
    if isinstance(value, str) and expected.startswith(("an int", "a float")):
        return _hint_of_number(expected, value)
    if callable(value) and not isinstance(value, type):
        return f"; write {getattr(value, '__name__', 'it')}() to call it"
    return ""


def _hint_of_number(expected: str, text: str) -> str:
    """Return the number to write in place of a text with a number, also with a decimal comma."""
    match = _NUMBER.fullmatch(text)
    if match is None or (match[1] and expected.startswith("an int")):
        return ""
    return f"; write {text.strip().replace(',', '.')}, without quotes"


class FieldTypeError(ZbotError, TypeError, AssertionError):
    """A message's field got a value of the wrong Python type (ROS 2: AssertionError).

    Attributes:
        type_name: The message, e.g. `geometry_msgs/msg/Vector3`.
        field: The field's name, with an index if one element is wrong: `ranges[3]`.
        expected: Description of a valid value.
        value: The given value.
    """

    def __init__(
        self, type_name: str, field: str, expected: str, value: object, hint: str = ""
    ) -> None:
        self.type_name, self.field, self.expected, self.value = type_name, field, expected, value
        hint = _hint(expected, value) or hint
        super().__init__(
            f"field {field!r} of {type_name} must be {expected}, not {described(value)}{hint}"
        )


class FieldValueError(ZbotError, ValueError, AssertionError):
    """A message's field got a value of the right type, but the field cannot hold the value.

    The attributes are those of `FieldTypeError`.
    """

    def __init__(self, type_name: str, field: str, expected: str, value: object) -> None:
        self.type_name, self.field, self.expected, self.value = type_name, field, expected, value
        given = shortened(value)
        super().__init__(f"field {field!r} of {type_name} must be {expected}, not {given}")


class UnknownFieldError(ZbotError, TypeError, AssertionError):
    """A message was constructed with a field that its type does not have."""

    def __init__(self, type_name: str, field: str, fields: tuple[str, ...]) -> None:
        self.type_name, self.field, self.fields = type_name, field, fields
        hint = did_you_mean(field, fields) or f"it has {', '.join(fields) or 'none'}"
        super().__init__(f"{type_name} has no field {field!r}; {hint}")


def positional_field_error(type_name: str, fields: tuple[str, ...]) -> WrongTypeError:
    """Return the error that a message was constructed with positional arguments."""
    short = type_name.rpartition("/")[2]
    example = f"{fields[0]}=..." if fields else ""
    return WrongTypeError(f"give the fields of {type_name} by name: {short}({example})")


class NotAMessageTypeError(ZbotError, TypeError, AttributeError):
    """A class was used as a message, service or action, but it is another kind of class.

    The error is also an AttributeError, because rclpy raises AttributeError for such a class.
    """

    def __init__(self, given: object, reason: str) -> None:
        self.given, self.reason = given, reason
        name = getattr(given, "__qualname__", None) or getattr(given, "__name__", None)
        super().__init__(
            f"{name or shortened(given)} cannot be used as an interface type: {reason}"
        )


class InterfaceKindError(NotAMessageTypeError, RuntimeError):
    """A class has the wrong kind, e.g. a service class in place of a message class."""

    def __init__(self, given: object, kind: str, expected: str) -> None:
        super().__init__(given, f"it is {kind}, not {expected}")
        self.expected = expected
