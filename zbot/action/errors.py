"""What a user of actions can do wrong."""

from __future__ import annotations

from zbot.errors import ZbotError


class NotAnActionTypeError(ZbotError, TypeError):
    """A class was used as an action type that is none, such as a message or a service."""

    def __init__(self, given: object) -> None:
        self.given = given
        name = given.__qualname__ if isinstance(given, type) else repr(given)
        super().__init__(
            f"{name} is no action type: take one from a package's `action` module, such as "
            "example_interfaces.action.Fibonacci"
        )


class ActionMessageError(ZbotError, TypeError):
    """A goal, result or feedback is of another type than its action says."""

    def __init__(self, action: str, expected: str, value: object) -> None:
        self.action, self.expected, self.value = action, expected, value
        text = repr(value)
        text = text if len(text) <= 80 else f"{text[:77]}..."
        super().__init__(f"{action} takes a {expected}, not {text}")


class ExecuteCallbackError(ZbotError, TypeError):
    """A server's callback for goals cannot be called."""

    def __init__(self, value: object) -> None:
        self.value = value
        super().__init__(f"Failed to register goal execution callback: {value!r} is not callable")
