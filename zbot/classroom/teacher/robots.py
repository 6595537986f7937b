"""Robots of a class, and the student who drives each of them."""

from __future__ import annotations

import json
import time
from typing import TYPE_CHECKING, Any

from zbot.classroom.errors import robot_error
from zbot.classroom.keys import ROBOTS_KEY

if TYPE_CHECKING:
    import zenoh

# A robot is connected if its bridge has asked within this time. A bridge asks twice a second, but
# cannot ask while the hub reopens.
_LOST_S = 5.0


class Robots:
    """Robots whose bridges ask the class, and their drivers. The caller must hold a lock."""

    def __init__(self) -> None:
        self._seen_s: dict[str, float] = {}
        self._drivers: dict[str, int] = {}

    @property
    def drivers(self) -> dict[str, int]:
        """The driver's number for each robot. A robot without a driver is left out."""
        return dict(self._drivers)

    def note(self, robot: str) -> int | None:
        """Note that a robot's bridge runs. Return the number of the driver, if there is one."""
        self._seen_s[robot] = time.monotonic()
        return self._drivers.get(robot)

    def connected(self) -> list[str]:
        """Return the robots whose bridges run."""
        late_s = time.monotonic() - _LOST_S
        return sorted(name for name, seen_s in self._seen_s.items() if seen_s > late_s)

    def give(self, robot: str, number: int | None) -> None:
        """Give a robot to one student. `None` means that nobody drives the robot.

        Raises:
            ClassroomError: No bridge of this robot runs.
        """
        connected = self.connected()
        if number is None:
            self._drivers.pop(robot, None)
            return
        if robot not in connected:
            raise robot_error(robot, connected)
        self._drivers[robot] = number

    def publish(self, session: zenoh.Session) -> None:
        """Tell the bridges who drives."""
        session.put(ROBOTS_KEY, json.dumps({"drivers": self._drivers}))


def driver_in(document: dict[str, Any], robot: str) -> int | None:
    """Return a robot's driver from what `Robots.publish` has published, or `None`."""
    drivers = document.get("drivers")
    number = drivers.get(robot) if isinstance(drivers, dict) else None
    return number if isinstance(number, int) else None
