"""Errors in the use of actions."""

from __future__ import annotations

from typing import Any

from zbot.errors import ZbotError, shortened
from zbot.interfaces.message import call_text
from zbot.interfaces.python_class import type_name


class NotAnActionTypeError(ZbotError, TypeError):
    """A class that is not an action type, such as a message, was used as an action type."""

    def __init__(self, given: object) -> None:
        self.given = given
        name = given.__qualname__ if isinstance(given, type) else repr(given)
        super().__init__(
            f"{name} is not an action type: take one from a package's `action` module, such as "
            "example_interfaces.action.Fibonacci"
        )


class ActionMessageError(ZbotError, TypeError):
    """A value is not of its action's `Goal`, `Result` or `Feedback` class."""

    def __init__(self, action: str, expected: type[Any], value: object) -> None:
        self.action, self.expected, self.value = action, type_name(expected), value
        advice = f"{call_text(expected)}{', with parentheses' * isinstance(value, type)}"
        super().__init__(
            f"{action} takes a {self.expected}, not {shortened(value)}; write {advice}"
        )
