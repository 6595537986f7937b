"""Errors of payloads and tokens that cannot be read or written."""

from __future__ import annotations

from zbot.errors import ZbotError


class TokenError(ZbotError, ValueError):
    """A liveliness key is not a token of a zbot node, e.g. because another program made the key."""

    def __init__(self, key: str, reason: str) -> None:
        self.key, self.reason = key, reason
        super().__init__(f"not a liveliness token: {key[:200]!r}: {reason}")


class CodecError(ZbotError, ValueError):
    """A message cannot be encoded, or bytes cannot be decoded as a message of the type.

    Attributes:
        action: `encode` or `decode`.
        type_name: The type, e.g. `sensor_msgs/msg/Image`.
        field: Path of the wrong field, e.g. `header.stamp.sec`. It is empty if the error is not
            about a single field.
        reason: The problem.
    """

    def __init__(self, action: str, type_name: str, field: str, reason: str) -> None:
        self.action, self.type_name, self.field, self.reason = action, type_name, field, reason
        where = f"field {field!r}: " if field else ""
        super().__init__(f"cannot {action} {type_name}: {where}{reason}")

    def replacement(self) -> str:
        """Return what a decoder did with the wrong value, for an error that it could ignore."""
        where = f"field {self.field!r} of " if self.field else ""
        return (
            f"a value of {where}{self.type_name} is not valid: {self.reason}; bytes that are not "
            "UTF-8 are read as U+FFFD, and a bool that is not 0 is read as true"
        )
