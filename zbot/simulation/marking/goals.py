"""Goals of a run: what a robot must do in a world."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.simulation.marking.sight import Sight

#: A robot is at a place if its middle is not farther away than this.
REACHED_M = 0.25
#: A robot follows a wall if its lidar is not farther from it than this.
WALL_M = 0.6
#: How far a robot may be away from the wall, e.g. at a corner.
_CORNER_M = 0.8
#: How long a robot must stand, and how far it must have driven before.
_STAND_S, _MOVED_M = 1.0, 0.1
#: The noise of a lidar lets a program stop a little too early.
_STOP_TOLERANCE_M = 0.05


@dataclass
class Goal:
    """What a robot must do.

    Attributes:
        text: The goal in the words of the teacher.
        limit_s: The time of the world in which the goal must be met.
        is_met: Whether the robot has done it.
        is_missed: Whether the robot cannot do it any more.
    """

    text: str
    limit_s: float
    is_met: bool = field(default=False, init=False)
    is_missed: bool = field(default=False, init=False)

    #: Whether the goal holds as long as nothing breaks it.
    holds = False

    @property
    def is_decided(self) -> bool:
        """Whether the robot has done it, or cannot do it any more."""
        return self.is_met or self.is_missed

    def look(self, sight: Sight) -> None:
        """Look at the robot after a step."""
        raise NotImplementedError

    @property
    def reason(self) -> str:
        """Why the goal is not met, in words that follow the robot's name `it`."""
        raise NotImplementedError

    @property
    def problem(self) -> str:
        """The goal and why it is not met. Empty if it is met."""
        is_good = self.is_met or (self.holds and not self.is_missed)
        return "" if is_good else f"{self.text}: {self.reason}"


@dataclass(frozen=True)
class Target:
    """Place that a goal names."""

    name: str
    x: float
    y: float

    def distance(self, sight: Sight) -> float:
        """Return how far the robot is away."""
        x, y = sight.place
        return math.hypot(x - self.x, y - self.y)


@dataclass
class Reaches(Goal):
    """The robot comes to a place."""

    target: Target
    _nearest: tuple[float, float] = field(default=(math.inf, 0.0), init=False)

    def look(self, sight: Sight) -> None:
        """Store the nearest that the robot comes."""
        self._nearest = min(self._nearest, (self.target.distance(sight), sight.now_s))
        self.is_met = self._nearest[0] <= REACHED_M

    @property
    def reason(self) -> str:
        """How near the robot came."""
        distance, when_s = self._nearest
        return f"the nearest it came was {distance:.2f} m away, at {when_s:.1f} s"


@dataclass
class Visits(Goal):
    """The robot comes to several places, in any order."""

    targets: Sequence[Target]
    _left: list[Target] = field(default_factory=list, init=False)

    def __post_init__(self) -> None:
        self._left = list(self.targets)

    def look(self, sight: Sight) -> None:
        """Strike off the places where the robot is."""
        self._left = [at for at in self._left if at.distance(sight) > REACHED_M]
        self.is_met = not self._left

    @property
    def reason(self) -> str:
        """The places where the robot did not come."""
        return f"it did not come to {' and '.join(at.name for at in self._left)}"


@dataclass
class TouchesNothing(Goal):
    """The robot touches nothing but the floor."""

    holds = True
    _touched: str = field(default="", init=False)

    def look(self, sight: Sight) -> None:
        """Look at the contacts of the robot."""
        name = sight.touched
        if name:
            what = "a wall" if name == "wall" else name
            self._touched, self.is_missed = f"it touched {what} at {sight.now_s:.1f} s", True

    @property
    def reason(self) -> str:
        """What the robot touched first."""
        return self._touched


@dataclass
class FollowsWall(Goal):
    """The robot drives some way near walls. At a corner it may be away for a moment."""

    way_m: float
    _near_m: float = field(default=0.0, init=False)
    _away_m: float = field(default=0.0, init=False)
    _best_m: float = field(default=0.0, init=False)
    _before_m: float = field(default=0.0, init=False)

    def look(self, sight: Sight) -> None:
        """Add the way since the last look."""
        way, self._before_m = sight.way_m - self._before_m, sight.way_m
        if sight.gap_m <= WALL_M:
            self._near_m, self._away_m = self._near_m + way, 0.0
        else:
            self._away_m += way
            if self._away_m > _CORNER_M:
                self._near_m = 0.0
        self._best_m = max(self._best_m, self._near_m)
        self.is_met = self._near_m >= self.way_m

    @property
    def reason(self) -> str:
        """How far the robot came."""
        return f"it drove {self._best_m:.1f} m of {self.way_m:g} m near a wall"


@dataclass
class StopsNear(Goal):
    """The robot drives, and then stands near an obstacle."""

    most_m: float
    _since_s: float | None = field(default=None, init=False)
    _gap_m: float | None = field(default=None, init=False)

    def look(self, sight: Sight) -> None:
        """Look whether the robot has stood for a moment."""
        if sight.way_m < _MOVED_M or not sight.stands:
            self._since_s = None
            return
        if self._since_s is None:
            self._since_s = sight.now_s
        elif sight.now_s - self._since_s >= _STAND_S:
            self._gap_m = sight.gap_m
            self.is_met = self._gap_m <= self.most_m + _STOP_TOLERANCE_M

    @property
    def reason(self) -> str:
        """Where the robot stood."""
        if self._gap_m is None:
            return "it never stopped"
        return f"it stopped {self._gap_m:.2f} m away"
