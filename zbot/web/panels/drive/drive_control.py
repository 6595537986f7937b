"""Control of one robot by one browser: the publisher, behind the dead man's switch."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.web.panels.drive.dead_man_switch import DeadManSwitch
from zbot.web.panels.drive.drive_message import joy, read_word, twist, velocity
from zbot.web.panels.drive.drive_target import TWIST

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.web.page.panel import Section
    from zbot.web.panels.drive.drive_message import SpeedLimits
    from zbot.web.panels.drive.drive_target import DriveTarget

_CLOCK = "/clock"
_CLOCK_TYPE = "rosgraph_msgs/msg/Clock"


class DriveControl:
    """Control of a target until its section of the page is closed.

    Args:
        section: The section of the page.
        target: The topic and its type.
        limits: The speed limits. They may change.

    Raises:
        ViewerError: The page is read-only.
    """

    def __init__(self, section: Section, target: DriveTarget, limits: SpeedLimits) -> None:
        self._section, self._target, self._limits = section, target, limits
        self._publisher = section.system.publisher(target.topic, target.type_name)
        self._clock = None if target.type_name == TWIST else section.watch(_CLOCK, _CLOCK_TYPE)
        self._switch = DeadManSwitch(self._send)
        section.keep(self)

    @property
    def velocity(self) -> tuple[float, float, float]:
        """The velocity that was sent last: ahead and to the left in m/s, and the turn in rad/s."""
        return velocity(self._switch.values, self._limits)

    def hear(self, arguments: Any) -> None:
        """Take a word of the browser, and answer it."""
        word = read_word(arguments)
        if word is None:
            return
        if self._switch.hear(word.press, word.values, word.said_s):
            self._section.page.call("zbotDrive.heard", word.number)
        else:
            self._section.page.call("zbotDrive.refused", word.press)

    def stop(self) -> None:
        """Stop the robot, if this browser drives it."""
        self._switch.stop()

    def release(self) -> None:
        """Stop the robot, and stop publishing. A second call does nothing."""
        self._switch.stop()
        self._publisher.release()

    def _send(self, values: Sequence[float]) -> None:
        if not self._publisher.entity.is_open:
            return  # the program ends
        if self._target.is_gamepad:
            message = joy(values, self._stamp())
        else:
            stamp = None if self._target.type_name == TWIST else self._stamp()
            message = twist(velocity(values, self._limits), stamp)
        self._publisher.entity.publish(message)

    def _stamp(self) -> Any:
        """Return the present time. In a simulation it is that of `/clock`."""
        system = self._section.system
        simulated = self._clock.latest if self._clock is not None else None
        if simulated is not None and system.snapshot().publishers(_CLOCK):
            return simulated.clock
        return system.node.get_clock().now().to_msg()
