"""World of the turtles: a square in which time advances by ticks. It uses no clock or messages.

Constants and the order of operations are the same as in ROS 2's turtlesim, so that the output is
the same as in tutorials. In this module y points down, as in a picture. In messages y points up.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from dataclasses import dataclass, field
from enum import Enum
from struct import pack, unpack

from zbot_nodes.turtlesim.drawing import HEIGHT, Drawing, Line, Pen

TICK_S = 0.016  #: seconds of one tick
PIXELS_PER_METRE = 45.0
#: Metres of one side. turtlesim uses a 32-bit float, and its output shows the rounding error.
SIZE: float = unpack("f", pack("f", (HEIGHT - 1) / PIXELS_PER_METRE))[0]

_PI = 3.14159265  # the value in turtlesim
_COMMAND_LASTS_S = 1.0
_TURN_SPEED = 1.0  # rad/s towards the heading of a rotation goal
_CLOSE_ENOUGH = 0.02  # rad

#: Function that logs. Its arguments are `info`, `warning` or `error`, and a string.
Log = Callable[[str, str], None]


def normal(angle: float) -> float:
    """Return an angle, in rad, between -pi and pi."""
    return angle - 2 * _PI * math.floor((angle + _PI) / (2 * _PI))


class RotationState(Enum):
    """State of a rotation goal."""

    ACTIVE = "active"
    SUCCEEDED = "succeeded"
    CANCELED = "canceled"
    ABORTED = "aborted"


@dataclass
class Rotation:
    """Goal of a turtle: to turn to a heading."""

    theta: float  #: heading in rad, as requested
    on_progress: Callable[[float], None] = lambda _: None  #: gets the remaining angle, rad
    on_end: Callable[[RotationState, float], None] = lambda *_: (
        None
    )  #: gets `start` minus the heading, rad
    is_cancel_requested: Callable[[], bool] = lambda: False
    start: float = 0.0  #: heading at the start, rad


def finite(value: float) -> float:
    """Return a number, or 0 for NaN and infinity. A web page sends NaN if it has no number."""
    return value if math.isfinite(value) else 0.0


@dataclass
class Turtle:
    """Turtle. Lengths are in metres, angles are in rad, and y points down."""

    name: str
    x: float
    y: float
    heading: float
    pen: Pen = field(default_factory=Pen)
    forward: float = 0.0  #: m/s
    sideways: float = 0.0  #: m/s to the left
    turn: float = 0.0  #: rad/s
    rotation: Rotation | None = None
    _since_command_s: float = math.inf
    _teleports: list[Callable[[], None]] = field(default_factory=list)

    @property
    def y_up(self) -> float:
        """Distance from the lower edge in metres."""
        return SIZE - self.y

    @property
    def speed(self) -> float:
        """Speed in m/s, never negative."""
        return math.hypot(self.forward, self.sideways)

    def command(self, forward: float, turn: float, sideways: float | None = None) -> None:
        """Set a velocity, which lasts 1 s. `None` keeps the present value of `sideways`."""
        self.forward, self.turn = finite(forward), finite(turn)
        if sideways is not None:
            self.sideways = finite(sideways)
        self._since_command_s = 0.0

    def teleport_to(self, x: float, y_up: float, heading: float) -> None:
        """Jump to a pose at the next tick."""
        x, y_up, heading = finite(x), finite(y_up), finite(heading)

        def go() -> None:
            self.x, self.y, self.heading = x, max(0.0, SIZE - y_up), heading

        self._teleports.append(go)

    def teleport_by(self, linear: float, angular: float) -> None:
        """Turn and then jump ahead at the next tick."""
        linear, angular = finite(linear), finite(angular)

        def go() -> None:
            self.heading += angular
            self.x += math.cos(self.heading) * linear
            self.y -= math.sin(self.heading) * linear

        self._teleports.append(go)

    def set_pen(self, r: int, g: int, b: int, width: int, off: int) -> None:
        """Put the pen down with a colour and a width in pixels (0 means 1), or lift it."""
        lifted = self.pen._replace(is_down=False)
        self.pen = lifted if off else Pen(r, g, b, width or 1)

    def rotate(self, rotation: Rotation, log: Log) -> None:
        """Begin to turn to a heading. A previous goal that has not ended is aborted."""
        if self.rotation is not None:
            log(
                "warning",
                "Rotation goal received before a previous goal finished. Aborting previous goal",
            )
            self.end_rotation(RotationState.ABORTED)
        rotation.start = self.heading
        rotation.theta = finite(rotation.theta)
        self.rotation = rotation

    def end_rotation(self, state: RotationState) -> None:
        """Report the end of the present goal, and remove it."""
        rotation, self.rotation = self.rotation, None
        if rotation is not None:
            rotation.on_end(state, normal(rotation.start - self.heading))

    def tick(self, drawing: Drawing, log: Log) -> None:
        """Advance by 16 ms."""
        self._jump(drawing)
        self._since_command_s += TICK_S
        if self.rotation is not None:
            self._follow(self.rotation, log)
        if self._since_command_s > _COMMAND_LASTS_S:
            self._stop()
        old_x, old_y = self.x, self.y
        self._move(log)
        if self.pen.is_down and (self.x, self.y) != (old_x, old_y):
            self._draw(drawing, old_x, old_y)

    def _jump(self, drawing: Drawing) -> None:
        teleports, self._teleports = self._teleports, []
        for teleport in teleports:
            old_x, old_y = self.x, self.y
            teleport()
            if self.pen.is_down:
                self._draw(drawing, old_x, old_y)

    def _follow(self, rotation: Rotation, log: Log) -> None:
        if rotation.is_cancel_requested():
            log("info", "Rotation goal canceled")
            self._stop()
            self.end_rotation(RotationState.CANCELED)
            return
        remaining = normal(rotation.theta - self.heading)
        rotation.on_progress(remaining)
        if abs(normal(self.heading - rotation.theta)) < _CLOSE_ENOUGH:
            log("info", "Rotation goal completed successfully")
            self._stop()
            self.end_rotation(RotationState.SUCCEEDED)
            return
        self.command(0.0, _TURN_SPEED if remaining >= 0 else -_TURN_SPEED, 0.0)

    def _stop(self) -> None:
        self.forward = self.sideways = self.turn = 0.0

    def _move(self, log: Log) -> None:
        self.heading = normal(self.heading + self.turn * TICK_S)
        cos, sin = math.cos(self.heading), math.sin(self.heading)
        self.x += (cos * self.forward - sin * self.sideways) * TICK_S
        self.y -= (cos * self.sideways + sin * self.forward) * TICK_S
        if not (0 <= self.x <= SIZE and 0 <= self.y <= SIZE):
            log(
                "warning",
                f"Oh no! I hit the wall! (Clamping from [x={self.x:.6f}, y={self.y:.6f}])",
            )
        self.x = min(max(self.x, 0.0), SIZE)
        self.y = min(max(self.y, 0.0), SIZE)

    def _draw(self, drawing: Drawing, old_x: float, old_y: float) -> None:
        scale = PIXELS_PER_METRE
        line = Line(old_x * scale, old_y * scale, self.x * scale, self.y * scale, self.pen)
        drawing.add(line)


class TurtleWorld:
    """World with all turtles and their drawing.

    Args:
        log: Function that logs texts for the user.
    """

    def __init__(self, log: Log = lambda _level, _text: None) -> None:
        self._log = log
        self.turtles: dict[str, Turtle] = {}
        self.drawing = Drawing()
        self._has_begun = False
        self._numbers = itertools.count(1)
        self.spawn(SIZE / 2, SIZE / 2, 0.0)

    def spawn(self, x: float, y_up: float, theta: float, name: str = "") -> Turtle | None:
        """Add a turtle. If the name is empty, the turtle gets the next free name, e.g. `turtle2`.

        Returns:
            The turtle, or `None` if the name is taken.
        """
        if not name:
            free = (f"turtle{number}" for number in self._numbers)
            name = next(name for name in free if name not in self.turtles)
        elif name in self.turtles:
            self._log("error", f"A turtle named [{name}] already exists")
            return None
        x, y_up, theta = finite(x), finite(y_up), finite(theta)
        turtle = self.turtles[name] = Turtle(name, x, SIZE - y_up, theta)
        self._log("info", f"Spawning turtle [{name}] at x=[{x:f}], y=[{y_up:f}], theta=[{theta:f}]")
        return turtle

    def kill(self, name: str) -> None:
        """Remove a turtle. An unknown name is only logged."""
        turtle = self.turtles.pop(name, None)
        if turtle is None:
            self._log("error", f"Tried to kill turtle [{name}], which does not exist")
        else:
            turtle.end_rotation(RotationState.ABORTED)

    def clear(self) -> None:
        """Clear the drawing. The turtles stay."""
        self._log("info", "Clearing turtlesim.")
        self.drawing.clear()

    def reset(self) -> None:
        """Start again with one turtle."""
        self._log("info", "Resetting turtlesim.")
        for turtle in self.turtles.values():
            turtle.end_rotation(RotationState.ABORTED)
        self.turtles.clear()
        self._numbers = itertools.count(1)
        self.spawn(SIZE / 2, SIZE / 2, 0.0)
        self.drawing.clear()

    def rotate(self, name: str, rotation: Rotation) -> None:
        """Let a turtle turn to a heading.

        Raises:
            KeyError: There is no such turtle.
        """
        self.turtles[name].rotate(rotation, self._log)

    def command(
        self, name: str, forward: float, turn: float, sideways: float | None = None
    ) -> None:
        """Set a turtle's velocity. Its rotation goal is aborted.

        Raises:
            KeyError: There is no such turtle.
        """
        turtle = self.turtles[name]
        if turtle.rotation is not None:
            self._log("warning", "Velocity command received during rotation goal. Aborting goal")
            turtle.end_rotation(RotationState.ABORTED)
        turtle.command(forward, turn, sideways)

    def colour_under(self, turtle: Turtle) -> tuple[int, int, int]:
        """Return red, green and blue of the drawing below a turtle."""
        return self.drawing.colour_at(turtle.x * PIXELS_PER_METRE, turtle.y * PIXELS_PER_METRE)

    def tick(self) -> bool:
        """Advance by 16 ms, except at the first tick. Return whether time advanced."""
        if not self._has_begun:
            self._has_begun = True
            return False
        for name in sorted(self.turtles):
            self.turtles[name].tick(self.drawing, self._log)
        return True
