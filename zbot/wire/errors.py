"""Errors of bytes and tokens that cannot be read or written."""

from __future__ import annotations

from zbot.errors import ZbotError


class TokenError(ZbotError, ValueError):
    """A liveliness key is no token of a zbot node, e.g. because another program declared it."""

    def __init__(self, key: str, reason: str) -> None:
        self.key, self.reason = key, reason
        super().__init__(f"not a liveliness token: {key[:200]!r}: {reason}")


class CodecError(ZbotError, ValueError):
    """A message cannot become bytes, or bytes cannot become a message of the type expected.

    Attributes:
        action: `encode` or `decode`.
        type_name: The type, e.g. `sensor_msgs/msg/Image`.
        field: Path of the field concerned, e.g. `header.stamp.sec`; empty if it is no single one.
        reason: What is wrong.
    """

    def __init__(self, action: str, type_name: str, field: str, reason: str) -> None:
        self.action, self.type_name, self.field, self.reason = action, type_name, field, reason
        where = f"field {field!r}: " if field else ""
        super().__init__(f"cannot {action} {type_name}: {where}{reason}")
