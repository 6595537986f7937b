"""Robot in SDF: a model with sensors and plugins."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot.simulation.gazebo.equipment import GazeboTags, read_equipment
from zbot.simulation.gazebo.names import GazeboNames
from zbot.simulation.gazebo.sensors import Mounted
from zbot.simulation.robots.model import fitted
from zbot.simulation.sdf.document import Document
from zbot.simulation.sdf.model import read_model, trees
from zbot.simulation.sdf.tree import tree_model

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.libraries.robot_description.urdf import Robot
    from zbot.simulation.robots.equipment import Equipment
    from zbot.simulation.robots.model import GazeboPlace, RobotModel
    from zbot.simulation.sdf.model import SdfModel
    from zbot.tf2.rigid import Rigid


def robot_of(model: SdfModel, place: GazeboPlace) -> tuple[RobotModel, Rigid]:
    """Return the robot of a model, and the pose of its root in the model.

    Raises:
        SimulationError: The model cannot be simulated.
        DescriptionError: A value is not valid.
    """
    links, *others = trees(model)
    found, root = tree_model(model, links)
    if others:
        model.notices.append(f"the link '{others[0][0]}', which no joint connects,")
    equipment = equipment_of(model, place, found.tree.root)
    equipment = fitted(equipment, found.tree, found.parts, found.solids)
    notices = (*model.notices, *equipment.notices)
    friction = found.equipment.friction | equipment.friction
    equipment = replace(equipment, friction=friction, notices=tuple(dict.fromkeys(notices)))
    is_fixed = found.is_fixed or model.is_static
    return replace(found, equipment=equipment, is_fixed=is_fixed, is_gazebo=True), root


def tree_of(text: str) -> Robot:
    """Return the links and joints of the model in an SDF text.

    Raises:
        SimulationError: The model is too large.
        DescriptionError: The text is not SDF, or it has no model.
    """
    model = model_of(text)
    found, _ = tree_model(model, next(trees(model)))
    return found.tree


def equipment_of(model: SdfModel, place: GazeboPlace, root: str) -> Equipment:
    """Return the equipment of a model.

    Raises:
        DescriptionError: A value is not valid.
    """
    names = GazeboNames(place.name, place.world, namespace=place.namespace)
    sensors = [
        Mounted(link.name, element) for link in model.links.values() for element in link.sensors
    ]
    tags = GazeboTags(sensors, model.plugins, {})
    link = model.links.get(root)
    model_in_root = None if link is None else link.pose.inverse()
    return read_equipment(tags, names, root, model_in_root)


def model_of(text: str, folder: Path | None = None) -> SdfModel:
    """Return the model in an SDF text.

    Args:
        text: The text.
        folder: The folder of relative addresses in it.

    Raises:
        SimulationError: The text includes too many files.
        DescriptionError: The text is not SDF, or it has no model.
    """
    document = Document(text, folder)
    element = document.root.find("model")
    element = document.root.find("world/model") if element is None else element
    if element is None:
        raise DescriptionError("it has no <model>")
    model = read_model(element, document.root.get("version", ""))
    if not model.links:
        raise DescriptionError("its <model> has no <link>")
    model.notices[:0] = document.notices
    return model
