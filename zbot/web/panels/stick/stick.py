"""State of the sticks and buttons on the screen, published as messages of a gamepad."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

from zbot.interfaces import get_message

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.observer.system import System

TYPE = "sensor_msgs/msg/Joy"
RATE_HZ = 20.0
BUTTONS = 11
#: For each stick, the axes for left and right, and the axes for up and down. Axes 0, 1, 3 and 4 are
#: those of common gamepads. Axes 2 and 5 are the default axes of teleop_twist_joy.
STICKS = (((0,), (1,)), ((2, 3), (4, 5)))
_AXES = 8
#: A browser that is silent for this time does not move the axes any more. A visible page is never
#: silent for this time.
_SILENCE_S = 1.5


class Stick:
    """Axes and buttons that a browser moves. They are published while one of them is not 0.

    If the browser is silent for 1.5 s, e.g. because its machine sleeps, all published values are 0.

    Args:
        system: The system, whose node publishes.
        topic: Full name of the topic.
        clock: Function that returns seconds.
    """

    def __init__(
        self, system: System, topic: str, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self._system, self.topic, self._clock = system, topic, clock
        self.axes = [0.0] * _AXES
        self.buttons = [0] * BUTTONS
        self._repetition: Any = None
        self._seen_s = clock()

    def move(self, stick: int, x: float, y: float) -> None:
        """Move a stick: `x` from -1 (left) to 1, `y` from -1 (down) to 1.

        Raises:
            ViewerError: The page is read-only.
        """
        across, along = STICKS[stick]
        for axis in across:
            self.axes[axis] = min(1.0, max(-1.0, -x)) + 0.0  # 0.0 in place of -0.0
        for axis in along:
            self.axes[axis] = min(1.0, max(-1.0, y))
        self._publish()

    def press(self, button: int, *, is_pressed: bool) -> None:
        """Press or release a button.

        Raises:
            ViewerError: The page is read-only.
        """
        self.buttons[button] = int(is_pressed)
        self._publish()

    def keep_alive(self) -> None:
        """Note that the browser is not silent."""
        self._seen_s = self._clock()

    def release(self) -> None:
        """Set all axes and buttons to 0, and stop publishing. A second call does nothing."""
        self.axes, self.buttons = [0.0] * _AXES, [0] * BUTTONS
        self._publish()

    def message(self) -> Any:
        """Return the message of the present state."""
        message: Any = get_message(TYPE)()
        is_there = self._clock() - self._seen_s < _SILENCE_S
        message.axes = list(self.axes) if is_there else [0.0] * _AXES
        message.buttons = list(self.buttons) if is_there else [0] * BUTTONS
        message.header.stamp = self._system.node.get_clock().now().to_msg()
        message.header.frame_id = "joy"
        return message

    def _publish(self) -> None:
        self.keep_alive()
        is_held = any(self.axes) or any(self.buttons)
        if is_held and self._repetition is None:
            self._repetition = self._system.repeat(self.topic, TYPE, self.message, RATE_HZ)
        elif not is_held and self._repetition is not None:
            with self._system.publisher(self.topic, TYPE) as reference:
                reference.entity.publish(self.message())
            repetition, self._repetition = self._repetition, None
            repetition.release()
