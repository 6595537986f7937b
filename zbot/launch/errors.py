"""What can go wrong with launch files and with what they start."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from zbot.errors import ZbotError, close_matches

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.launch.entity import Origin


class LaunchError(ZbotError):
    """Root of what can go wrong while launching."""


class InvalidLaunchFileError(LaunchError):
    """A launch file makes no sense.

    Attributes:
        extension: What its name ends in.
        likely_errors: What reading it in one way and another led to.
    """

    def __init__(self, extension: str = "", *, likely_errors: Iterable[BaseException] = ()) -> None:
        self.extension, self.likely_errors = extension, list(likely_errors)
        found = "; ".join(describe(error) for error in self.likely_errors)
        kind = f"launch file in '{extension}'" if extension else "launch file"
        super().__init__(f"{kind} makes no sense: {found or 'nothing reads it'}")


class LaunchFileError(InvalidLaunchFileError):
    """A launch file, or one line of it, makes no sense.

    Attributes:
        path: The file.
        line: Line number from 1; 0 if none can be named.
        reason: What is wrong.
    """

    def __init__(self, path: str, line: int, reason: str, hint: str = "") -> None:
        super().__init__(os.path.splitext(path)[1])  # noqa: PTH122 - "<text>" is no path
        self.path, self.line, self.reason, self.hint = path, line, reason, hint
        self.args = (f"{path}:{line}: {reason}" if line else f"{path}: {reason}",)

    @classmethod
    def at(cls, origin: Origin, error: BaseException) -> LaunchFileError:
        """Return an error that happened to what a line of a launch file made."""
        reason = str(error) if isinstance(error, ZbotError) else describe(error)
        return cls(origin.path, origin.line, reason, getattr(error, "hint", "") or "")


class IncludeLoopError(LaunchError):
    """A launch file includes itself, by way of others or not, without end."""

    def __init__(self, chain: Iterable[str]) -> None:
        self.chain = tuple(chain)
        super().__init__(f"launch files include each other without end: {' -> '.join(self.chain)}")


class LaunchFileNotFoundError(LaunchError, FileNotFoundError):
    """There is no launch file of that name or path."""

    def __init__(self, message: str, hint: str = "") -> None:
        self.hint = hint
        super().__init__(message)


class NoSourceError(LaunchError, RuntimeError):
    """A launch description is to come from nowhere."""

    def __init__(self) -> None:
        super().__init__("this source has neither a launch description nor the path of a file")


class LaunchArgumentError(LaunchError, RuntimeError, ValueError):
    """A launch argument is missing, malformed or not one of the choices."""

    def __init__(self, message: str, hint: str = "") -> None:
        self.hint = hint
        super().__init__(message)

    @classmethod
    def malformed(cls, word: str) -> LaunchArgumentError:
        """Return the error for a word that is no `name:=value`."""
        return cls(f"malformed launch argument '{word}', expected format '<name>:=<value>'")

    @classmethod
    def missing(cls, name: str, description: str) -> LaunchArgumentError:
        """Return the error for an argument that has no default and was not given."""
        told = f' (description: "{description}")' if description else ""
        text = f'Required launch argument "{name}"{told} was not provided'
        return cls(text, f"give it a value: {name}:=VALUE")

    @classmethod
    def no_choice(cls, name: str, value: str, choices: Iterable[str]) -> LaunchArgumentError:
        """Return the error for a value that is none of the choices."""
        known = list(choices)
        near = close_matches(value, known, 1)
        hint = f"did you mean {name}:={near[0]}?" if near else ""
        text = f"launch argument '{name}': the value '{value}' is not valid."
        return cls(f"{text} Valid options are: {known}", hint)

    @classmethod
    def no_default(cls, name: str, value: str, choices: Iterable[str]) -> LaunchArgumentError:
        """Return the error for a default that is none of the choices."""
        told = ", ".join(f"'{choice}'" for choice in choices)
        return cls(
            f"the default '{value}' of launch argument '{name}' is not in provided choices {told}"
        )


class IncludeArgumentError(LaunchArgumentError):
    """An included launch file needs an argument that the include does not give."""

    def __init__(self, name: str, given: Iterable[str]) -> None:
        told = ", ".join(given)
        text = f'Included launch description missing required argument "{name}", given: [{told}]'
        super().__init__(text, f"add '{name}' to the launch_arguments of the include")


class SubstitutionError(LaunchError, RuntimeError, ValueError):
    """A substitution cannot be turned into text."""

    def __init__(self, message: str, hint: str = "") -> None:
        self.hint = hint
        super().__init__(message)


class UnknownNameError(SubstitutionError, NameError):
    """A Python expression has a name that nothing has; it may need a module."""


class ConditionError(LaunchError, ValueError):
    """A condition is neither true nor false."""

    def __init__(self, text: str) -> None:
        self.text = text
        super().__init__(f"a condition must be true, false, 1 or 0, not '{text}'")


class CoercionError(LaunchError, ValueError):
    """A text means nothing of the type that is wanted, or there is no such type."""


class ProgramError(LaunchError):
    """A program cannot be started."""

    def __init__(self, message: str, hint: str = "") -> None:
        self.hint = hint
        super().__init__(message)


class EntityTypeError(LaunchError, TypeError, ValueError):
    """Something is in a launch description, or given to an action, that does not belong there.

    launch raises a TypeError in some places, a ValueError in others.
    """

    def __init__(self, where: str, expected: str, value: object) -> None:
        self.where, self.expected, self.value = where, expected, value
        super().__init__(f"{where} must be {expected}, not {type(value).__name__}: {value!r}")


class UnknownHandlerError(LaunchError, ValueError):
    """An event handler is to see no more events, but sees none."""

    def __init__(self, handler: object) -> None:
        self.handler = handler
        super().__init__(f"this event handler is not registered: {handler!r}")


class UnbalancedPopError(LaunchError, RuntimeError):
    """Something is to be returned to that was not remembered."""

    def __init__(self, kind: str) -> None:
        self.kind = kind
        super().__init__(f"no {kind.replace('_', ' ')} were pushed that could be popped")


class ArgumentCountError(LaunchError, TypeError):
    """A substitution was given too few arguments, or too many."""

    def __init__(self, name: str, expected: int, given: int) -> None:
        self.name, self.expected, self.given = name, expected, given
        plural = "" if expected == 1 else "s"
        super().__init__(f"{name} expects {expected} argument{plural}, not {given}")


class LogLevelError(LaunchError, KeyError):
    """A line is to be logged at a level that there is not."""

    def __init__(self, level: str, known: Iterable[str]) -> None:
        self.level, self.known = level, tuple(known)
        super().__init__(f"Invalid log level '{level}': it is one of {', '.join(self.known)}")

    def __str__(self) -> str:
        return str(self.args[0])  # KeyError would show its repr


class ExposeError(LaunchError, RuntimeError):
    """Something is to make the actions of a tag, or the substitutions of a name, that cannot."""

    def __init__(self, kind: str, name: str) -> None:
        self.kind, self.name = kind, name
        text = f"Exposed {kind} parser for {name} is not a callable or a class"
        super().__init__(f"{text} containing a parse method")


class OutputError(LaunchError, ValueError):
    """`output` of a program names no place that its lines can go to."""

    def __init__(self, word: object, known: Iterable[str]) -> None:
        self.word, self.known = word, tuple(known)
        super().__init__(f"output must be one of {', '.join(self.known)}, not {word!r}")


def describe(error: BaseException) -> str:
    """Return one line that says what a Python exception says."""
    text = " ".join(str(error).split())
    return f"{type(error).__name__}: {text}" if text else type(error).__name__
