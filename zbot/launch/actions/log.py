"""Actions that write a log line."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.launch.action import Action
from zbot.launch.errors import LogLevelError
from zbot.launch.substitution import describe, normalize, perform

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType

_LEVELS = {
    **{level: level for level in ("DEBUG", "INFO", "WARNING", "ERROR")},
    "WARN": "WARNING",
    "FATAL": "ERROR",
    "CRITICAL": "ERROR",
}


def _known(level: str) -> str:
    """Return Python's name of a log level."""
    if level.upper() not in _LEVELS:
        raise LogLevelError(level, _LEVELS)
    return _LEVELS[level.upper()]


class Log(Action):
    """Write a log line.

    Args:
        msg: The text.
        level: `debug`, `info`, `warning` or `error`.

    Raises:
        LogLevelError: The level does not exist.
    """

    def __init__(
        self, *, msg: SomeSubstitutionsType, level: SomeSubstitutionsType, **options: Any
    ) -> None:
        super().__init__(**options)
        self.msg, self.level = normalize(msg), normalize(level)
        if isinstance(level, str):
            _known(level)

    def execute(self, context: LaunchContext) -> None:
        """Write the line."""
        level = _known(perform(context, self.level))
        context.writer.log(level, "launch.user", perform(context, self.msg))

    def describe(self) -> str:
        """Return the text."""
        return f"{type(self).__name__}({describe(self.msg)})"


class LogInfo(Log):
    """Write a line at level INFO."""

    def __init__(self, *, msg: SomeSubstitutionsType, **options: Any) -> None:
        super().__init__(msg=msg, level=options.pop("level", "INFO"), **options)


class LogDebug(LogInfo):
    """Write a line at level DEBUG. The screen shows it only with `--debug`."""

    def __init__(self, *, msg: SomeSubstitutionsType, **options: Any) -> None:
        super().__init__(msg=msg, level="DEBUG", **options)


class LogWarning(LogInfo):
    """Write a line at level WARNING."""

    def __init__(self, *, msg: SomeSubstitutionsType, **options: Any) -> None:
        super().__init__(msg=msg, level="WARNING", **options)


class LogError(LogInfo):
    """Write a line at level ERROR."""

    def __init__(self, *, msg: SomeSubstitutionsType, **options: Any) -> None:
        super().__init__(msg=msg, level="ERROR", **options)
