"""Program of the simulator: a world, its robots, and the node that moves them until Ctrl-C."""

from __future__ import annotations

import contextlib
import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from zbot.runtime import init, spin
from zbot.simulation.errors import SimulationError
from zbot.simulation.node.gazebo_program import add_entities
from zbot.simulation.node.pace import Pace
from zbot.simulation.node.simulator import Simulator
from zbot.simulation.places import free_places
from zbot.simulation.robots.catalog import find_robot
from zbot.simulation.world import World
from zbot.simulation.worlds.file import find_world
from zbot.tf2.rigid import Rigid

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from contextlib import AbstractContextManager

    from zbot.simulation.robots.model import RobotModel
    from zbot.simulation.worlds.plan import Place

_MOST_ROBOTS = 100


@dataclass(frozen=True)
class Options:
    """What to simulate.

    Attributes:
        world: The name of a world, or a file.
        robots: The names of robots, or files. Without any, there is the two-wheeled robot.
        count: The number of robots, if `robots` has at most one. None means one.
        rate: Simulated seconds in a real second. None means as fast as possible.
        seed: The seed of all noise.
        has_world_frame: Whether the true pose of the odometry is published as a transform.
        in_lockstep: Whether the simulator waits for the nodes that follow its time.
        has_handles: Whether users can move robots and things in the 3D view.
    """

    world: str = "room"
    robots: Sequence[str] = ()
    count: int | None = None
    rate: float | None = 1.0
    seed: int = 0
    has_world_frame: bool = True
    in_lockstep: bool = False
    has_handles: bool = False


def simulate(
    options: Options,
    around: Callable[[], AbstractContextManager[object]] = contextlib.nullcontext,
    *,
    args: Sequence[str] = (),
) -> None:
    """Simulate a world until a signal ends the program.

    Args:
        options: What to simulate.
        around: A function that returns the `with` block in which the world moves.
        args: The words of `--ros-args`.

    Raises:
        SimulationError: The world or a robot cannot be simulated, or the domain has a simulator.
        DescriptionError: A file is not a valid robot description.
        MissingPackageError: The extra `sim` is not installed.
    """
    found = find_world(options.world)
    world = World(found.spec, seed=options.seed, earth=found.earth)
    is_own = bool(found.entities) and not options.robots and options.count is None
    robots = [] if is_own else robots_of(options, world, found.start)
    with init(args=list(args)):
        node = Simulator(
            *(world, Pace(options.rate)),
            has_world_frame=options.has_world_frame,
            in_lockstep=options.in_lockstep,
            world_name=found.name,
        )
        add_entities(node, found)
        node.add_robots(robots)
        if options.has_handles:
            node.show_handles()
        names = ", ".join(world.robots)
        node.get_logger().info(f"The world '{options.world}' has the robots: {names}")
        with around():
            node.pace.restart()
            spin(node)


def robots_of(
    options: Options, world: World, start: Place
) -> list[tuple[str, str, RobotModel, Rigid]]:
    """Return the names, the namespaces, the models and the free places of robots.

    Args:
        options: What to simulate.
        world: The world.
        start: Where the first robot starts.

    Raises:
        SimulationError: A robot cannot be simulated, or the world has not enough free places.
        DescriptionError: A file is not a valid robot description.
    """
    models = _models(options)
    return _named(models, free_places(world, start, len(models)))


def _models(options: Options) -> list[RobotModel]:
    names = list(options.robots) or ["two_wheeled"]
    if options.count is not None:
        if len(names) > 1:
            raise SimulationError("--robots needs at most one --robot")
        if not 0 < options.count <= _MOST_ROBOTS:
            raise SimulationError(f"--robots must be 1 to {_MOST_ROBOTS}, not {options.count}")
        names *= options.count
    known = {name: find_robot(name) for name in dict.fromkeys(names)}
    return [known[name] for name in names]


def _named(
    models: Sequence[RobotModel], places: Sequence[Place]
) -> list[tuple[str, str, RobotModel, Rigid]]:
    """Return names, namespaces, models and poses. A single robot has no namespace."""
    found = []
    for number, (model, place) in enumerate(zip(models, places, strict=True), start=1):
        name = "robot" if len(models) == 1 else f"robot{number}"
        half = place.yaw / 2
        pose = Rigid((place.x, place.y, 0.0), (0.0, 0.0, math.sin(half), math.cos(half)))
        found.append((name, "" if len(models) == 1 else name, model, pose))
    return found
