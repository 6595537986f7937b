"""Program of the simulator for launch files and programs that are written for Gazebo."""

from __future__ import annotations

import contextlib
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.errors import ZbotError
from zbot.runtime import init, spin
from zbot.simulation.node.pace import Pace
from zbot.simulation.node.simulator import Gazebo, Simulator
from zbot.simulation.robots.model import GazeboPlace
from zbot.simulation.sdf.resources import find_resource
from zbot.simulation.sdf.robot import robot_of
from zbot.simulation.world import World
from zbot.simulation.worlds.catalog import WORLDS
from zbot.simulation.worlds.file import FoundWorld, find_world
from zbot.simulation.worlds.plan import Place, Plan

if TYPE_CHECKING:
    from collections.abc import Callable
    from contextlib import AbstractContextManager

    from zbot.simulation.node.simulator import RunningControl
    from zbot.simulation.robots.robot import Robot

#: Worlds that Gazebo brings, as worlds of zbot: only a floor.
_EMPTY = frozenset({"empty", "default", "shapes", "empty_world"})


@dataclass(frozen=True)
class GazeboOptions:
    """What to simulate.

    Attributes:
        world: A file, or the name of a world of Gazebo or zbot.
        is_classic: Whether the programs are those for Gazebo Classic.
        is_paused: Whether the time stands still until a program lets it run.
        seed: The seed of all noise.
        start_control: A function that starts the controller manager of a robot.
    """

    world: str = "empty"
    is_classic: bool = False
    is_paused: bool = False
    seed: int = 0
    start_control: Callable[[Simulator, Robot], RunningControl] | None = None


def simulate_gazebo(
    options: GazeboOptions,
    around: Callable[[], AbstractContextManager[object]] = contextlib.nullcontext,
) -> None:
    """Simulate a world until a signal ends the program.

    Args:
        options: What to simulate.
        around: A function that returns the `with` block in which the world moves.

    Raises:
        SimulationError: The world cannot be simulated, or the domain has a simulator.
        MissingPackageError: The extra `sim` is not installed.
    """
    found = world_of(options.world)
    world = World(found.spec, seed=options.seed, earth=found.earth)
    with init():
        gazebo = Gazebo(options.is_classic, options.start_control)
        node = Simulator(
            world, Pace(1.0), has_world_frame=False, world_name=found.name, gazebo=gazebo
        )
        node.is_paused = options.is_paused
        add_entities(node, found)
        node.get_logger().info(f"The world '{found.name}' is simulated by zbot")
        with around():
            node.pace.restart()
            spin(node)


def world_of(name: str) -> FoundWorld:
    """Return a world by the name or the file that programs of Gazebo use.

    Raises:
        SimulationError: There is no such world, or it cannot be simulated.
    """
    if name in WORLDS:
        return find_world(name)
    path = find_resource(name) or find_resource(f"worlds/{name}")
    if path is None and Path(name).stem in _EMPTY:
        stem = Path(name).stem
        return FoundWorld(Plan().spec(), Place(), stem if "sdf" in name else "default")
    return find_world(name if path is None else str(path))


def add_entities(node: Simulator, found: FoundWorld) -> None:
    """Add the robots of a world, and say what is left out.

    A robot that cannot be simulated is named, and the world runs without it.
    """
    for notice in found.notices:
        node.get_logger().warning(f"The world: {notice} is left out")
    for entity in found.entities:
        try:
            model, root = robot_of(entity.model, GazeboPlace(entity.name, found.name))
            row = (entity.name, "", model, entity.pose @ root)
            node.add_robots([row], on_floor=False)
        except ZbotError as error:
            node.get_logger().error(f"The model '{entity.name}' is left out: {error}")
