"""Lines on the screen."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.launch.action import Action
from zbot.launch.substitution import describe, normalize, perform

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType

_LEVELS = {"WARN": "WARNING", "FATAL": "ERROR", "CRITICAL": "ERROR"}


class Log(Action):
    """Write a line.

    Args:
        msg: The text.
        level: `debug`, `info`, `warning` or `error`.
    """

    def __init__(
        self, *, msg: SomeSubstitutionsType, level: SomeSubstitutionsType, **options: Any
    ) -> None:
        super().__init__(**options)
        self.msg, self.level = normalize(msg), normalize(level)

    def execute(self, context: LaunchContext) -> None:
        """Write it."""
        level = perform(context, self.level).upper()
        text = perform(context, self.msg)
        context.journal.log(_LEVELS.get(level, level), "launch.user", text)

    def describe(self) -> str:
        """Return the text."""
        return f"{type(self).__name__}({describe(self.msg)})"


class LogInfo(Log):
    """Write what happens."""

    def __init__(self, *, msg: SomeSubstitutionsType, **options: Any) -> None:
        super().__init__(msg=msg, level=options.pop("level", "INFO"), **options)


class LogDebug(LogInfo):
    """Write a line that only `--debug` shows."""

    def __init__(self, *, msg: SomeSubstitutionsType, **options: Any) -> None:
        super().__init__(msg=msg, level="DEBUG", **options)


class LogWarning(LogInfo):
    """Write what may be wrong."""

    def __init__(self, *, msg: SomeSubstitutionsType, **options: Any) -> None:
        super().__init__(msg=msg, level="WARNING", **options)


class LogError(LogInfo):
    """Write what is wrong."""

    def __init__(self, *, msg: SomeSubstitutionsType, **options: Any) -> None:
        super().__init__(msg=msg, level="ERROR", **options)
