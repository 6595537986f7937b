"""Errors of the bridge."""

from __future__ import annotations

import sys

from zbot.errors import ZbotError
from zbot.errors.installation import pip_install


class BridgeError(ZbotError):
    """The bridge cannot do what it was asked for."""


def no_rclpy_error(reason: str) -> BridgeError:
    """Return the error that this Python cannot import a genuine rclpy."""
    if sys.platform == "linux":
        advice = (
            "source your ROS 2 (`source /opt/ros/<name>/setup.bash`), "
            f"or type `{pip_install('zbot[ros2]')}`"
        )
    else:
        advice = "run the bridge on a Linux machine: there are no packages for this system"
    return BridgeError(f"this Python cannot import ROS 2's rclpy ({reason}): {advice}")


class PatternError(BridgeError, ValueError):
    """A pattern of `--topics`, `--services`, `--actions` or `--rate` is not valid."""

    def __init__(self, text: str, reason: str) -> None:
        self.text, self.reason = text, reason
        super().__init__(f"cannot use {text!r}: {reason}")


class CallError(BridgeError):
    """A service call that the bridge carried failed.

    Attributes:
        kind: `no_server`, `server_gone`, or the kind of error that the other side has reported.
        message: Why it failed.
    """

    def __init__(self, kind: str, message: str) -> None:
        self.kind, self.message = kind, message
        super().__init__(message)
