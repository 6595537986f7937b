"""Errors of loggers and their levels."""

from __future__ import annotations

from zbot.errors import ZbotError


class InvalidSeverityError(ZbotError, ValueError, RuntimeError):
    """A severity does not exist. rclpy raises ValueError for numbers and RuntimeError for texts."""

    def __init__(self, severity: object) -> None:
        self.severity = severity
        super().__init__(
            f"{severity!r} is not a log severity: use DEBUG (10), INFO (20), WARN (30), "
            "ERROR (40) or FATAL (50)"
        )


class LogOptionError(ZbotError, TypeError):
    """A log call has an unknown option, or lacks an option that another option needs."""

    def __init__(self, option: str, reason: str) -> None:
        self.option, self.reason = option, reason
        super().__init__(f"log parameter {option!r} {reason}")


class LogCallChangedError(ZbotError, ValueError):
    """A place in the source makes a different log call than before.

    Filters such as `once` have a state for each place in the source, so the call at a place must
    stay the same, as in rclpy.

    Attributes:
        what: The part that changed, e.g. `severity`.
        place: File and line of the call.
    """

    def __init__(self, what: str, place: str) -> None:
        self.what, self.place = what, place
        super().__init__(
            f"a log call's {what} cannot be changed between calls: "
            f"write separate log calls ({place})"
        )


class NotAClockError(ZbotError, ValueError):
    """An argument that must be a clock is not a clock."""

    def __init__(self, argument: str, value: object) -> None:
        self.argument, self.value = argument, value
        super().__init__(
            f"{argument} must be a Clock instance, for example node.get_clock(), not {value!r}"
        )
