"""Messages of the panel Drive: velocities within limits, and the axes and buttons of a gamepad."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

from zbot.interfaces import get_message
from zbot.web.panels.drive.drive_target import JOY, TWIST, TWIST_STAMPED

if TYPE_CHECKING:
    from collections.abc import Sequence

#: Frame of a TwistStamped: the velocity is that of the robot's body.
FRAME = "base_link"
BUTTONS = 11
#: For each stick, the axes for left and right, and the axes for up and down. Axes 0, 1, 3 and 4 are
#: those of common gamepads. Axes 2 and 5 are the default axes of teleop_twist_joy.
STICKS = (((0,), (1,)), ((2, 3), (4, 5)))
_AXES = 8
_MOST_VALUES = 64
_FASTEST = 100.0


@dataclass(slots=True)
class SpeedLimits:
    """Velocities at the end of a stick's way."""

    linear_m_s: float = 0.5
    angular_rad_s: float = 1.0

    def set(self, linear_m_s: object, angular_rad_s: object) -> None:
        """Set the limits. A value that is not a number of at least 0 changes nothing."""
        self.linear_m_s = _limit(linear_m_s, self.linear_m_s)
        self.angular_rad_s = _limit(angular_rad_s, self.angular_rad_s)


def _limit(given: object, before: float) -> float:
    if isinstance(given, int | float) and 0 <= given <= _FASTEST:
        return float(given)
    return before


class Word(NamedTuple):
    """What a browser says."""

    press: int
    number: int
    values: list[float]  #: from -1 to 1
    said_s: float  #: when it was said, on the browser's clock


def read_word(arguments: Any) -> Word | None:
    """Return a word of a browser, or None if a browser sent something else."""
    try:
        press, number, values, said_ms = arguments
        found = [float(value) for value in values[:_MOST_VALUES]]
        press, number, said_s = int(press), int(number), float(said_ms) / 1000
    except (TypeError, ValueError, OverflowError):
        return None
    if not all(map(math.isfinite, [*found, said_s])):
        return None
    return Word(press, number, [max(-1.0, min(1.0, value)) for value in found], said_s)


def velocity(values: Sequence[float], limits: SpeedLimits) -> tuple[float, float, float]:
    """Return the velocity ahead and to the left in m/s, and the turn in rad/s.

    Args:
        values: The same three from -1 to 1. Missing ones are 0.
        limits: The velocities for 1.
    """
    ahead, left, turn = (*values, 0.0, 0.0, 0.0)[:3]
    # A diagonal is not faster than the limit.
    length = max(1.0, math.hypot(ahead, left))
    speed = limits.linear_m_s / length
    return ahead * speed, left * speed, turn * limits.angular_rad_s


def twist(speeds: tuple[float, float, float], stamp: Any = None) -> Any:
    """Return a Twist, or with a stamp a TwistStamped."""
    message: Any = get_message(TWIST)()
    message.linear.x, message.linear.y, message.angular.z = speeds
    if stamp is None:
        return message
    stamped: Any = get_message(TWIST_STAMPED)(twist=message)
    stamped.header.stamp, stamped.header.frame_id = stamp, FRAME
    return stamped


def joy(values: Sequence[float], stamp: Any) -> Any:
    """Return the message of a gamepad.

    Args:
        values: For the left and the right stick, the ways to the right and up from -1 to 1. Then
            the buttons, each 0 or 1.
        stamp: The stamp.
    """
    message: Any = get_message(JOY)()
    axes = [0.0] * _AXES
    for number, (across, along) in enumerate(STICKS):
        x, y = (*values[2 * number : 2 * number + 2], 0.0, 0.0)[:2]
        for axis in across:
            axes[axis] = -x + 0.0  # 0.0 in place of -0.0
        for axis in along:
            axes[axis] = y
    buttons = [int(value > 0) for value in values[2 * len(STICKS) :]]
    message.axes, message.buttons = axes, (buttons + [0] * BUTTONS)[:BUTTONS]
    message.header.stamp, message.header.frame_id = stamp, "joy"
    return message
