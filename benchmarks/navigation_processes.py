"""Reach random goals in real time, with each node in a process of its own.

Run: python -m benchmarks.navigation_processes [--goals 50] [--world office] [--seed 1]

`zbot sim` simulates. The launch files `slam_launch.py`, later `localization_launch.py`, and
`navigation_launch.py` of nav2_bringup drive the robot, and `BasicNavigator` sends the goals. The
tour, the goals and the rule of success are those of `benchmarks.navigation`.
"""

from __future__ import annotations

import argparse
import math
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

import psutil
from ros_gz_interfaces.msg import Contacts

import zbot
from benchmarks.navigation import TOURS, free_places, reach
from benchmarks.navigation_world import place_in_map
from zbot.libraries.navigation.navigator import BasicNavigator, TaskResult
from zbot.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data

from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import OccupancyGrid, Odometry

if TYPE_CHECKING:
    from collections.abc import Callable

_DOMAIN = 76
_LIMIT_S = 120.0
_KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class Programs:
    """Programs of zbot that run beside this one, with their children."""

    def __init__(self) -> None:
        self._running: dict[str, psutil.Popen] = {}

    def start(self, name: str, *words: str) -> None:
        """Start `zbot WORDS`."""
        command = [sys.executable, "-m", "zbot_cli", "--domain", str(_DOMAIN), *words]
        self._running[name] = psutil.Popen(
            command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )

    def stop(self, name: str) -> None:
        """End a program."""
        program = self._running.pop(name)
        program.terminate()
        program.wait(30)

    def stop_all(self) -> None:
        """End all programs."""
        for name in list(self._running):
            self.stop(name)

    def used_s(self) -> float:
        """Return the processor time of all programs and their children."""
        alive = [
            process
            for program in self._running.values()
            for process in (program, *program.children(recursive=True))
        ]
        return float(sum(sum(process.cpu_times()[:4]) for process in alive))


class Driver:
    """Node that sends goals, and knows the true pose and what the robot has touched."""

    def __init__(self) -> None:
        self.navigator = BasicNavigator()
        self.navigator.set_parameters([zbot.Parameter("use_sim_time", value=True)])
        self.truth: Any = None
        self.map: Any = None
        self.touched: list[str] = []
        listen: Callable[..., Any] = self.navigator.create_subscription
        listen(Odometry, "ground_truth", self._see, qos_profile_sensor_data)
        listen(OccupancyGrid, "map", self._take_map, _KEPT)
        listen(Contacts, "bumper", self._feel, 10)
        self.wait_for("bt_navigator")
        while self.truth is None or self.map is None:
            zbot.spin_once(self.navigator)
        self.start: tuple[float, float, float] = self.true_pose()

    def wait_for(self, node: str) -> None:
        """Wait until a managed node is active."""
        self.navigator._waitForNodeToActivate(node)  # noqa: SLF001 - Nav2 has no public name for it

    def _see(self, message: Any) -> None:
        self.truth = message.pose.pose

    def _take_map(self, message: Any) -> None:
        self.map = message

    def _feel(self, message: Any) -> None:
        self.touched += [contact.collision2.name for contact in message.contacts]

    @property
    def time_s(self) -> float:
        """The time in the world."""
        return self.navigator.get_clock().now().nanoseconds / 1e9

    def true_pose(self) -> tuple[float, float, float]:
        """Return the pose of the robot in the world."""
        at = self.truth.position
        return at.x, at.y, 2 * math.atan2(self.truth.orientation.z, self.truth.orientation.w)

    def pose(self, x: float, y: float, yaw: float) -> PoseStamped:
        """Return a pose in the map."""
        found = PoseStamped()
        found.header.frame_id = "map"
        found.header.stamp = self.navigator.get_clock().now().to_msg()
        found.pose.position.x, found.pose.position.y = x, y
        found.pose.orientation.z, found.pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
        return found

    def go(self, x: float, y: float, yaw: float = 0.0) -> bool:
        """Drive to a place of the map. Return whether navigation says that the robot is there."""
        if not self.navigator.goToPose(self.pose(x, y, yaw)):
            return False
        end_s = self.time_s + _LIMIT_S
        while not self.navigator.isTaskComplete():
            if self.time_s > end_s:
                self.navigator.cancelTask()
                break
        return bool(self.navigator.getResult() == TaskResult.SUCCEEDED)

    def localise(self) -> None:
        """Tell the localiser a place that is a little wrong."""
        self.wait_for("amcl")
        x, y = place_in_map(self.start, *self.true_pose()[:2])
        self.navigator.setInitialPose(
            self.pose(x + 0.2, y - 0.2, self.true_pose()[2] - self.start[2])
        )
        end_s = self.time_s + 5.0
        while self.time_s < end_s:
            zbot.spin_once(self.navigator)

    def away_m(self, x: float, y: float) -> float:
        """Return how far the robot truly is from a place of the map."""
        return math.dist((x, y), place_in_map(self.start, *self.true_pose()[:2]))


def run(programs: Programs, options: argparse.Namespace, folder: Path) -> None:
    """Map, localise, and reach the goals."""
    seed, use_time = str(options.seed), "use_sim_time:=true"
    programs.start("sim", "sim", options.world, "--headless", "--no-world-frame", "--seed", seed)
    for name in ("slam", "navigation"):
        programs.start(name, "launch", "nav2_bringup", f"{name}_launch.py", use_time)
    driver = Driver()
    for x, y in TOURS[options.world]:
        is_there = driver.go(*place_in_map(driver.start, x, y))
        print(f"tour ({x:.1f}, {y:.1f}): {is_there}", flush=True)
    words = ["run", "nav2_map_server", "map_saver_cli", "-f", "map", "--ros-args", "-p", use_time]
    command = [sys.executable, "-m", "zbot_cli", "--domain", str(_DOMAIN), *words]
    subprocess.run(command, cwd=folder, check=True, timeout=60)
    places = free_places(driver.map)
    programs.stop("slam")
    file = f"map:={folder / 'map.yaml'}"
    programs.start(
        "localization", "launch", "nav2_bringup", "localization_launch.py", use_time, file
    )
    driver.localise()
    measure(driver, programs, places, options)


def measure(
    driver: Driver,
    programs: Programs,
    places: list[tuple[float, float]],
    options: argparse.Namespace,
) -> None:
    """Send the robot to random goals, and print how it went."""
    begin_s, used_s, start_s = driver.time_s, programs.used_s(), time.monotonic()
    found = reach(driver, places, options)
    print(f"reached {len(found)} of {options.goals}, touched {len(driver.touched)} times")
    print(f"mean true distance {sum(found) / max(len(found), 1):.3f} m")
    world_s, real_s = driver.time_s - begin_s, time.monotonic() - start_s
    used_s = programs.used_s() - used_s
    print(f"{world_s:.0f} s in the world, {real_s:.0f} s, {used_s:.0f} s of one core")


def main() -> None:
    """Measure, and print the figures."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--world", default="office", choices=TOURS)
    parser.add_argument("--goals", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    options, programs = parser.parse_args(), Programs()
    with tempfile.TemporaryDirectory() as folder, zbot.init(domain_id=_DOMAIN):
        try:
            run(programs, options, Path(folder))
        finally:
            programs.stop_all()


if __name__ == "__main__":
    main()
