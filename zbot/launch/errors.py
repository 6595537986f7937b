"""Errors of launch files and of the programs that they start."""

from __future__ import annotations

import inspect
import os
import re
from typing import TYPE_CHECKING

from zbot.errors import ZbotError, shortened
from zbot.errors.suggestion import question, similar_names
from zbot.launch.argument_names import question_about
from zbot.package.errors import NotRunnableError
from zbot.package.unavailable import Unavailable
from zbot.text.typographic import advice

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

    from zbot.launch.entity import Origin


class LaunchError(ZbotError):
    """Base class of all launch errors."""


class InvalidLaunchFileError(LaunchError):
    """A launch file is invalid.

    Attributes:
        extension: The suffix of the file name.
        likely_errors: The errors of the attempts to read the file.
    """

    def __init__(self, extension: str = "", *, likely_errors: Iterable[BaseException] = ()) -> None:
        self.extension, self.likely_errors = extension, list(likely_errors)
        found = "; ".join(describe(error) for error in self.likely_errors)
        kind = f"'{extension}' launch file" if extension else "launch file"
        super().__init__(f"{kind} is invalid: {found or 'no parser can read it'}")


class LaunchFileError(InvalidLaunchFileError):
    """A launch file or one line of it is invalid.

    Attributes:
        path: The file.
        line: The line number, which starts at 1. It is 0 if the line is unknown.
        reason: What is wrong.
    """

    def __init__(self, path: str, line: int, reason: str, hint: str = "") -> None:
        super().__init__(os.path.splitext(path)[1])  # noqa: PTH122 - "<text>" is not a path
        self.path, self.line, self.reason = path, line, reason
        typed = advice(reason)
        self.hint = hint if not typed or typed in reason else typed
        self.args = (f"{path}:{line}: {reason}" if line else f"{path}: {reason}",)

    @classmethod
    def at(cls, origin: Origin, error: BaseException) -> LaunchFileError:
        """Return an entity's error, with the line of the launch file that created the entity."""
        reason = str(error) if isinstance(error, ZbotError) else describe(error)
        return cls(origin.path, origin.line, reason, getattr(error, "hint", "") or "")


def include_loop_error(chain: Iterable[str]) -> LaunchError:
    """Return the error that a launch file includes itself, directly or through other files."""
    return LaunchError(f"launch files include each other without end: {' -> '.join(chain)}")


class LaunchFileNotFoundError(LaunchError, FileNotFoundError):
    """No launch file has this name or path."""

    def __init__(self, message: str, hint: str = "") -> None:
        self.hint = hint
        super().__init__(message)


class TemplateError(NotRunnableError):
    """A launch file does not exist, but its template `*.in`, which a build fills in."""

    def __init__(self, template: Path) -> None:
        file = template.with_suffix("")
        kind = Unavailable(
            f"made from the template {template}",
            f"copy the template to {file.name} and replace each @NAME@ in it by a value",
            "CMake fills in when it builds the package",
        )
        super().__init__(file.name, kind)
        self.needed = file.name
        made = f"CMake makes it from the template {template} when it builds the package"
        self.args = (f"{file.name} does not exist here: {made}; {kind.instead}",)


class LaunchUsageError(LaunchError, RuntimeError, ValueError):
    """A launch argument is wrong or missing, or a class of launch is used incorrectly."""


def malformed_argument_error(word: str) -> LaunchUsageError:
    """Return the error for a word that does not have the form `name:=value`."""
    match = re.match(r"-*(\w+)\s*[:=]*(.*)", word)
    hint = f"write {match[1]}:={match[2] or 'VALUE'}" if match else ""
    text = f"malformed launch argument '{word}', expected format '<name>:=<value>'"
    return LaunchUsageError(text, hint=hint)


def missing_argument_error(name: str, description: str) -> LaunchUsageError:
    """Return the error for an argument that has no default and was not given."""
    details = f' (description: "{description}")' if description else ""
    text = f'Required launch argument "{name}"{details} was not provided'
    return LaunchUsageError(text, hint=f"give it a value: {name}:=VALUE")


def no_choice_error(name: str, value: str, choices: Iterable[str]) -> LaunchUsageError:
    """Return the error for a value that is not one of the choices."""
    known = list(choices)
    hint = question(f"{name}:={near}" for near in similar_names(value, known))
    text = f"launch argument '{name}': the value '{value}' is not valid."
    return LaunchUsageError(f"{text} Valid options are: {known}", hint=hint)


def no_default_error(name: str, value: str, choices: Iterable[str]) -> LaunchUsageError:
    """Return the error for a default value that is not one of the choices."""
    known = ", ".join(f"'{choice}'" for choice in choices)
    return LaunchUsageError(
        f"the default '{value}' of launch argument '{name}' is not in provided choices {known}"
    )


def missing_in_include_error(name: str, given: Iterable[str]) -> LaunchUsageError:
    """Return the error for an argument that an include does not give."""
    names = ", ".join(given)
    text = f'Included launch description missing required argument "{name}", given: [{names}]'
    return LaunchUsageError(text, hint=f"add '{name}' to the launch_arguments of the include")


class SubstitutionError(LaunchError, RuntimeError, ValueError):
    """zbot cannot find the text of a substitution."""

    def __init__(self, message: str, hint: str = "") -> None:
        self.hint = hint
        super().__init__(message)


class UnknownNameError(SubstitutionError, NameError):
    """A Python expression uses an undefined name, e.g. of a module not in `python_modules`."""


class ConditionError(LaunchError, ValueError):
    """A condition is neither true nor false."""

    def __init__(self, text: str) -> None:
        self.text = text
        super().__init__(f"a condition must be true, false, 1 or 0, not '{text}'")


class CoercionError(LaunchError, ValueError):
    """A string cannot be read as a value of a type, or the type is not supported."""


class ProgramError(LaunchError):
    """A program cannot be started."""

    def __init__(self, message: str, hint: str = "") -> None:
        self.hint = hint
        super().__init__(message)


class EntityTypeError(LaunchError, TypeError, ValueError):
    """A value in a launch description, or an argument of an action, has the wrong type.

    This error is both a TypeError and a ValueError, because ROS 2's launch raises one of the two.
    """

    def __init__(self, where: str, expected: str, value: object, hint: str = "") -> None:
        self.where, self.expected, self.value, self.hint = where, expected, value, hint
        given = f"{type(value).__name__}: {shortened(value, 200)}"
        super().__init__(f"{where} must be {expected}, not {given}")


class WrongArgumentsError(LaunchError, TypeError):
    """An action or a substitution was given arguments that it does not have."""


def unknown_argument_error(action: type[object], argument: str) -> WrongArgumentsError:
    """Return the error for an argument that an action does not have, e.g. `pkg` for `package`."""
    known = {
        name
        for base in action.__mro__
        for name, parameter in inspect.signature(base.__init__).parameters.items()  # type: ignore[misc] # of a class
        if parameter.kind is parameter.KEYWORD_ONLY
        or parameter.kind is parameter.POSITIONAL_OR_KEYWORD
    }
    hint = question_about(argument, known - {"self"})
    return WrongArgumentsError(f"{action.__name__} has no argument '{argument}'", hint=hint)


def argument_count_error(name: str, expected: int, given: int) -> WrongArgumentsError:
    """Return the error that a substitution has too few arguments or too many."""
    plural = "" if expected == 1 else "s"
    return WrongArgumentsError(f"{name} expects {expected} argument{plural}, not {given}")


class LaunchControlError(LaunchError):
    """A running launch has ended, or refuses a request of the page."""


class LogLevelError(LaunchError, KeyError):
    """A log level does not exist."""

    def __init__(self, level: str, known: Iterable[str]) -> None:
        self.level, self.known = level, tuple(known)
        super().__init__(f"Invalid log level '{level}': use one of {', '.join(self.known)}")

    def __str__(self) -> str:
        return str(self.args[0])  # KeyError would show the repr of the text


def output_error(word: object, known: Iterable[str]) -> LaunchUsageError:
    """Return the error that `output` of an action contains an unknown sink or stream."""
    return LaunchUsageError(f"output must be one of {', '.join(known)}, not {word!r}")


def describe(error: BaseException) -> str:
    """Return the type and the text of an exception in one line."""
    text = " ".join(str(error).split())
    return f"{type(error).__name__}: {text}" if text else type(error).__name__


class InvalidFrontendLaunchFileError(LaunchFileError, ValueError):
    """A launch file in XML or YAML is invalid."""


class MissingAttributeError(InvalidFrontendLaunchFileError, AttributeError):
    """A required attribute or child is missing."""


class AttributeTypeError(InvalidFrontendLaunchFileError, TypeError):
    """An attribute has the wrong type."""


class SubstitutionSyntaxError(ValueError):
    """A text with `$(...)` does not follow the grammar."""
