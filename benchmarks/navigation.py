"""Map a house, localise a robot in it, and send the robot to random goals.

Run: python -m benchmarks.navigation [--goals 50] [--world office] [--seed 1]

The simulator and all nodes run in one thread, and the time in the world waits for them. The robot
first drives through all rooms with the mapper. Then the mapper ends, the localiser gets the map,
and the robot gets one random goal after the other. The true pose and the bumper say how it went.
A real-time factor of at least 1 means that one core is enough.
"""

from __future__ import annotations

import argparse
import math
import random
import time
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from benchmarks.navigation_world import NavigationWorld, start_drivers
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot_nodes.navigation.amcl import Amcl
from zbot_nodes.navigation.grids.distances import distances
from zbot_nodes.navigation.grids.geometry import cells_of, geometry_of
from zbot_nodes.navigation.slam_toolbox_node import Mapper

from nav_msgs.msg import OccupancyGrid

if TYPE_CHECKING:
    from collections.abc import Sequence

_DOMAIN = 76
_STEPS = 5  # 20 ms
_KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
#: For each world: places from which the robot sees all of it, in the frame of the world.
TOURS: dict[str, Sequence[tuple[float, float]]] = {
    "office": (
        *((-3.7, 0.0), (-3.7, 1.8), (0.0, 0.0), (-0.1, 1.8), (3.5, 0.0), (3.5, 1.7)),
        *((3.5, -1.7), (0.0, 0.0), (-0.1, -1.8), (-3.7, -1.8), (-4.5, 0.0)),
    ),
    "room": ((2.5, -1.0), (0.0, 1.5), (0.0, 0.0)),
}
_CLEAR_M = 0.35  # goals are so far from obstacles and from what is unknown
_REACHED_M = 0.35  # the true distance from the goal at the end


def free_places(grid: Any) -> list[tuple[float, float]]:
    """Return places of a map that are far enough from all obstacles."""
    geometry = geometry_of(grid.info)
    away = distances(cells_of(grid) != 0, 20) * geometry.resolution
    points = geometry.centres(*np.nonzero(away >= _CLEAR_M))
    return [(float(x), float(y)) for x, y in points]


class GoalDriver(Protocol):
    """Drives a robot to places of the map."""

    touched: list[str]

    @property
    def time_s(self) -> float: ...
    def go(self, x: float, y: float, yaw: float = 0.0) -> bool: ...
    def away_m(self, x: float, y: float) -> float: ...


def reach(
    driver: GoalDriver, places: Sequence[tuple[float, float]], options: argparse.Namespace
) -> list[float]:
    """Send the robot to random places. Return its true distances from those that it reached."""
    numbers, found = random.Random(options.seed), []
    for number in range(options.goals):
        x, y = numbers.choice(places)
        is_there = driver.go(x, y, numbers.uniform(-math.pi, math.pi))
        away_m = driver.away_m(x, y)
        if is_there and away_m <= _REACHED_M:
            found.append(away_m)
        text = f"goal {number + 1} ({x:.2f}, {y:.2f}): {is_there}, {away_m:.2f} m away"
        print(f"{text}, {driver.time_s:.0f} s, touched {driver.touched[:2]}", flush=True)
    return found


class Run:
    """Run of one robot.

    Args:
        options: The words of the command line.
    """

    def __init__(self, options: argparse.Namespace) -> None:
        self.options = options
        self.world = NavigationWorld(options.world, _DOMAIN, seed=options.seed, steps=_STEPS)
        self.maps: list[Any] = []
        start_drivers(self.world)
        self.world.client_node.create_subscription(OccupancyGrid, "map", self.maps.append, _KEPT)

    def map(self) -> None:
        """Drive through all rooms, and keep the map."""
        world = self.world
        mapper = world.add(Mapper)
        world.wait(lambda: bool(self.maps), 10)
        for x, y in TOURS[self.options.world]:
            is_there = world.go(*world.in_map(x, y))
            print(f"tour ({x:.1f}, {y:.1f}): {is_there}, {world.time_s:.0f} s", flush=True)
        world.run(3)
        mapper.trigger_deactivate()

    def localise(self) -> None:
        """Give the map to the localiser, with a place that is a little wrong."""
        world = self.world
        x, y = world.in_map(*world.true_pose()[:2])
        start = {"initial_pose.x": x + 0.2, "initial_pose.y": y - 0.2}
        yaw = world.true_pose()[2] - world.start[2]
        publisher = world.client_node.create_publisher(OccupancyGrid, "map", _KEPT)
        publisher.publish(self.maps[-1])
        world.add(Amcl, {**start, "initial_pose.yaw": yaw})
        world.run(3)


def main() -> None:
    """Measure, and print the figures."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--world", default="office", choices=TOURS)
    parser.add_argument("--goals", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    run = Run(parser.parse_args())
    begin_s = time.process_time()
    run.map()
    mapped_s, mapped_cpu_s = run.world.time_s, time.process_time() - begin_s
    run.localise()
    found = reach(run.world, free_places(run.maps[-1]), run.options)
    drove_s = run.world.time_s - mapped_s
    drove_cpu_s = time.process_time() - begin_s - mapped_cpu_s
    print(f"reached {len(found)} of {run.options.goals}, touched {len(run.world.touched)} times")
    print(f"mean true distance {sum(found) / max(len(found), 1):.3f} m")
    print(f"mapping: {mapped_s:.0f} s in the world, {mapped_cpu_s:.0f} s of one core")
    print(f"goals: {drove_s:.0f} s in the world, {drove_cpu_s:.0f} s of one core")
    run.world.close()


if __name__ == "__main__":
    main()
