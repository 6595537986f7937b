"""Errors of things that are not zbot."""

from __future__ import annotations

from zbot.errors import SetupError, ZbotError


class DeviceError(ZbotError):
    """A board or a broker cannot be used, or an option is not valid."""


class DeviceSetupError(DeviceError, SetupError):
    """This machine is not ready for a board or a broker, e.g. a permission is missing."""


class UnreadableError(DeviceError, ValueError):
    """A text of a device is in no known form, or its value does not fit the topic's type.

    Attributes:
        reason: What is wrong. There are few different reasons, so that they can be counted.
        detail: What is wrong with this text. It may be empty.
    """

    def __init__(self, reason: str, detail: str = "", hint: str = "") -> None:
        self.reason, self.detail = reason, detail
        super().__init__(f"{reason}: {detail}" if detail else reason, hint=hint)
