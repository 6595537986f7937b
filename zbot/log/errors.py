"""Errors of loggers and their levels."""

from __future__ import annotations

from zbot.errors import WrongTypeError, WrongValueError, ZbotError


class InvalidSeverityError(ZbotError, ValueError, RuntimeError):
    """A severity does not exist. rclpy raises ValueError for numbers and RuntimeError for texts."""

    def __init__(self, severity: object) -> None:
        self.severity = severity
        super().__init__(
            f"{severity!r} is not a log severity: use DEBUG (10), INFO (20), WARN (30), "
            "ERROR (40) or FATAL (50)"
        )


def log_option_error(option: str, reason: str) -> WrongTypeError:
    """Return the error that a log call has an unknown option, or lacks an option."""
    return WrongTypeError(f"log parameter {option!r} {reason}")


def log_call_changed_error(what: str, place: str) -> WrongValueError:
    """Return the error that a place in the source makes a different log call than before."""
    return WrongValueError(
        f"a log call's {what} cannot be changed between calls: write separate log calls ({place})"
    )


def not_a_clock_error(argument: str, value: object) -> WrongValueError:
    """Return the error that an argument that must be a clock is not a clock."""
    return WrongValueError(
        f"{argument} must be a Clock instance, for example node.get_clock(), not {value!r}"
    )
