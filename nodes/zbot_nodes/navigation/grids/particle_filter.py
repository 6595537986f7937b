"""Particle filter: many guesses of a robot's pose, which motion spreads and scans weigh."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from zbot_nodes.navigation.grids.distances import distances
from zbot_nodes.robot.pose import Pose, turn_to

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from zbot_nodes.navigation.grids.geometry import GridGeometry

    Floats = NDArray[np.float64]

#: The rays of a scan are not independent: all of them together count as so many.
_INDEPENDENT_RAYS = 12.0
_BIN_M, _BIN_RAD = 0.5, 0.35  # for the count of different guesses


class LikelihoodField:
    """Probability to see an obstacle at each place of a map.

    Args:
        occupied: The occupied cells of the map.
        geometry: Where the cells are.
        sigma_m: How exact the lidar and the map are.
        farthest_m: Up to which distance from an obstacle the probability changes.
        share: The share of rays that hit an obstacle of the map.
    """

    def __init__(
        self,
        occupied: NDArray[np.bool_],
        geometry: GridGeometry,
        *,
        sigma_m: float = 0.2,
        farthest_m: float = 2.0,
        share: float = 0.5,
    ) -> None:
        cells = max(1, math.ceil(farthest_m / geometry.resolution))
        away = np.pad(distances(occupied, cells), 1, constant_values=cells) * geometry.resolution
        near = np.exp(-(away**2) / (2 * sigma_m**2))
        self._log = np.log(share * near + (1 - share) * 0.1)
        self.geometry = geometry

    def weigh(self, poses: Floats, points: Floats) -> Floats:
        """Return the logarithm of the probability of a scan at each pose."""
        cos, sin = np.cos(poses[:, 2, None]), np.sin(poses[:, 2, None])
        x = poses[:, 0, None] + cos * points[:, 0] - sin * points[:, 1]
        y = poses[:, 1, None] + sin * points[:, 0] + cos * points[:, 1]
        rows, columns = self.geometry.cells(np.stack([x, y], axis=-1))
        height, width = self.geometry.shape
        found = self._log[np.clip(rows, -1, height) + 1, np.clip(columns, -1, width) + 1]
        weights: Floats = found.mean(axis=1) * min(_INDEPENDENT_RAYS, len(points))
        return weights


@dataclass(frozen=True)
class MotionNoise:
    """Noise of the odometry: standard deviations for each metre and each radian driven."""

    turn_by_turn: float = 0.2
    turn_by_way: float = 0.2
    way_by_way: float = 0.2
    way_by_turn: float = 0.2
    strafe_by_way: float = 0.2  #: only for robots that drive sideways
    is_omnidirectional: bool = False


class Estimate(NamedTuple):
    """Pose of the largest group of guesses."""

    pose: Pose
    covariance: Floats  #: of x, y and the heading


class ParticleFilter:
    """Guesses of a robot's pose.

    Attributes:
        poses: x, y and heading of each guess.
        weights: The probability of each guess. Their sum is 1.
    """

    def __init__(self, seed: int | None = None) -> None:
        self._random = np.random.default_rng(seed)
        self.poses = np.zeros((1, 3))
        self.weights = np.ones(1)

    def spread_around(self, pose: Pose, covariance: Floats, count: int) -> None:
        """Guess that the robot is near a pose."""
        noise = self._random.multivariate_normal(np.zeros(3), covariance, count, method="eigh")
        self._set(np.array(pose) + noise)

    def spread_over(self, points: Floats, count: int) -> None:
        """Guess that the robot is at one of these points, and points in any direction."""
        chosen = points[self._random.integers(0, len(points), count)]
        headings = self._random.uniform(-math.pi, math.pi, count)
        self._set(np.column_stack([chosen, headings]))

    def _set(self, poses: Floats) -> None:
        self.poses = poses
        self.weights = np.full(len(poses), 1 / len(poses))

    def move(self, motion: Pose, noise: MotionNoise) -> None:
        """Move each guess as the odometry says, and a little otherwise.

        Args:
            motion: The pose of the robot in its frame of before.
            noise: How exact the odometry is.
        """
        way, turn = math.hypot(motion.x, motion.y), abs(motion.yaw)
        along = noise.way_by_way * way + noise.way_by_turn * turn * 0.1
        across = noise.strafe_by_way * way if noise.is_omnidirectional else 0.1 * along
        turning = noise.turn_by_turn * turn + noise.turn_by_way * way
        random = self._random.normal(size=(len(self.poses), 3))
        ahead = math.atan2(motion.y, motion.x) if way > 1e-6 else 0.0
        shift, side = random[:, 0] * along, random[:, 1] * across
        x = motion.x + shift * math.cos(ahead) - side * math.sin(ahead)
        y = motion.y + shift * math.sin(ahead) + side * math.cos(ahead)
        heading = self.poses[:, 2]
        self.poses[:, 0] += x * np.cos(heading) - y * np.sin(heading)
        self.poses[:, 1] += x * np.sin(heading) + y * np.cos(heading)
        self.poses[:, 2] = heading + motion.yaw + random[:, 2] * turning

    def weigh(self, field: LikelihoodField, points: Floats) -> None:
        """Make guesses that fit to a scan more probable."""
        if not len(points):
            return
        logs = np.log(self.weights + 1e-300) + field.weigh(self.poses, points)
        weights = np.exp(logs - np.max(logs))
        self.weights = weights / weights.sum()

    def resample(self, least: int, most: int, *, error: float = 0.05, z: float = 0.99) -> None:
        """Draw new guesses: the more probable a guess, the more often.

        The number of guesses follows the number of different ones (the KLD rule of D. Fox).
        """
        bins = len(np.unique(self._bins(), axis=0)) - 1
        part = 2 / (9 * max(bins, 1))
        needed = bins / (2 * error) * (1 - part + math.sqrt(part) * z) ** 3
        count = int(min(most, max(least, needed)))
        # One random number and equal steps: a guess of the weight w is drawn about w * count times.
        picks = (self._random.random() + np.arange(count)) / count
        ends = np.cumsum(self.weights)
        self._set(self.poses[np.searchsorted(ends / ends[-1], picks).clip(0, len(ends) - 1)])

    def _bins(self) -> NDArray[np.int64]:
        size = np.array([_BIN_M, _BIN_M, _BIN_RAD])
        poses = self.poses.copy()
        poses[:, 2] %= 2 * math.pi
        found: NDArray[np.int64] = np.floor(poses / size).astype(np.int64)
        return found

    def estimate(self) -> Estimate:
        """Return the mean pose of the guesses around the most probable place."""
        bins, members = np.unique(self._bins(), axis=0, return_inverse=True)
        sums = np.bincount(members.ravel(), self.weights, len(bins))
        best = self.poses[members.ravel() == np.argmax(sums)].mean(axis=0)
        turns = np.abs(np.angle(np.exp(1j * (self.poses[:, 2] - best[2]))))
        near = np.hypot(*(self.poses[:, :2] - best[:2]).T) < 2 * _BIN_M
        group = near & (turns < 2 * _BIN_RAD)
        weights = self.weights[group] / self.weights[group].sum()
        poses = self.poses[group]
        x, y = weights @ poses[:, :2]
        heading = math.atan2(weights @ np.sin(poses[:, 2]), weights @ np.cos(poses[:, 2]))
        away = poses - (x, y, heading)
        away[:, 2] = np.angle(np.exp(1j * away[:, 2]))
        covariance = (away * weights[:, None]).T @ away
        return Estimate(Pose(float(x), float(y), turn_to(heading)), covariance)
