"""Spawning of robots as in Gazebo: descriptions in URDF or SDF, and their names and poses."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, Protocol

from zbot.libraries.robot_description.file import read_description
from zbot.libraries.robot_description.xml_text import DescriptionError, read_xml
from zbot.names import validate_namespace
from zbot.simulation.errors import SimulationError
from zbot.simulation.robots.catalog import expanded
from zbot.simulation.robots.model import GazeboPlace, read_robot
from zbot.simulation.sdf.resources import find_resource
from zbot.simulation.sdf.robot import model_of, robot_of

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

    from zbot.simulation.robots.model import RobotModel
    from zbot.simulation.world import World
    from zbot.tf2.rigid import Rigid


class SpawningSimulator(Protocol):
    """The part of the simulator that spawning uses."""

    world: World
    world_name: str

    def add_robots(
        self, robots: Iterable[tuple[str, str, RobotModel, Rigid]], *, on_floor: bool = True
    ) -> None:
        """Add robots."""
        ...


class Wanted(NamedTuple):
    """Robot that a program wants to spawn."""

    name: str  #: empty for that in the description
    text: str  #: the description, or an empty text
    file: str  #: the file of the description, if there is no text
    pose: Rigid
    namespace: str = ""
    may_rename: bool = False


def spawn(simulator: SpawningSimulator, wanted: Wanted) -> str:
    """Add a robot with the topics of Gazebo. Return its name.

    Raises:
        SimulationError: The robot cannot be simulated, or its name is not free.
        DescriptionError: The description is not valid.
    """
    text, folder = (wanted.text, None) if wanted.text else _of_file(wanted.file)
    if wanted.namespace.strip("/"):
        validate_namespace(f"/{wanted.namespace.strip('/')}")
    name = _free(simulator.world, wanted.name or _name_in(text), wanted.may_rename)
    place = GazeboPlace(name, simulator.world_name, wanted.namespace)
    if _is_sdf(text):
        model = model_of(text, folder)
        robot, root = robot_of(model, place)
        pose = wanted.pose @ model.offset @ root
    else:
        robot, pose = read_robot(text, place), wanted.pose
    simulator.add_robots([(name, "", robot, pose)], on_floor=False)
    return name


def _of_file(address: str) -> tuple[str, Path | None]:
    path = find_resource(address) if address else None
    if path is not None and path.is_dir():
        path = path / "model.sdf"
    if path is None:
        raise SimulationError(f"there is no file '{address[:200]}'")
    if path.suffix == ".xacro":
        return expanded(path), path.parent
    return read_description(path), path.parent


def _is_sdf(text: str) -> bool:
    return read_xml(text).tag != "robot"


def _name_in(text: str) -> str:
    root = read_xml(text)
    model = root if root.tag in {"robot", "model"} else root.find(".//model")
    name = "" if model is None else model.get("name", "")
    if not name:
        raise DescriptionError("it has no name")
    return name


def _free(world: World, name: str, may_rename: bool) -> str:
    """Return a name that no other entity has. As a part of topics, it has no slash."""
    name = name.strip("/").replace("/", "_")
    if not name or len(name) > 100:
        raise SimulationError("a robot needs a name of at most 100 letters")
    if world.entity(name) is None:
        return name
    if not may_rename:
        raise SimulationError(f"there is already an entity '{name}'")
    number = 0
    while world.entity(f"{name}_{number}") is not None:
        number += 1
    return f"{name}_{number}"
