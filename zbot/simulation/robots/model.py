"""Model of a robot: all that a simulator needs from a robot description."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, NamedTuple

from zbot.libraries.robot_description.appearance import read_appearance
from zbot.libraries.robot_description.inertia import read_inertia
from zbot.libraries.robot_description.urdf import MOVING, read_urdf
from zbot.simulation.errors import SimulationError
from zbot.simulation.gazebo.control import controlled_joints
from zbot.simulation.gazebo.equipment import lumped_links, read_equipment, urdf_tags
from zbot.simulation.gazebo.names import GazeboNames, PlainNames
from zbot.simulation.robots.found_by_name import complete, find_drive, find_sensors
from zbot.tf2.rigid import Rigid

if TYPE_CHECKING:
    from collections.abc import Mapping

    from zbot.libraries.robot_description.appearance import Solid
    from zbot.libraries.robot_description.inertia import Inertia
    from zbot.libraries.robot_description.urdf import Joint, Robot
    from zbot.simulation.gazebo.control import ControlledJoint
    from zbot.simulation.robots.equipment import Equipment

    Solids = Mapping[str, list[Solid]]

#: Text at the end of the name of a frame that a joint turns, if its link is elsewhere.
AXIS_FRAME = "__axis"
_MOST_LINKS, _MOST_MOVING, _MOST_SOLIDS = 1000, 100, 2000


@dataclass(frozen=True)
class Part:
    """Links that move together: a link, and all links that fixed joints connect with it."""

    link: str
    joint: Joint | None  #: the joint that moves this part; None for the robot's root
    members: dict[str, Rigid]  #: the frames of the links in the part


@dataclass(frozen=True)
class RobotModel:
    """Robot as its description tells it."""

    text: str  #: the description in URDF
    tree: Robot
    solids: dict[str, list[Solid]]  #: what the robot collides with, by link
    inertia: dict[str, Inertia]  #: by link
    parts: tuple[Part, ...]  #: the root's part is first, and each parent is before its children
    equipment: Equipment
    is_fixed: bool = False  #: whether its root never moves, as that of an arm on a table
    controlled: tuple[ControlledJoint, ...] = ()  #: joints that a controller manager commands
    is_gazebo: bool = False  #: whether it has the topics of Gazebo

    @property
    def wheels(self) -> frozenset[str]:
        """The joints of the wheels that drive it."""
        drive = self.equipment.drive
        if drive is not None:
            return frozenset({*drive.left, *drive.right})
        return frozenset(
            joint.name
            for joint in self.controlled
            if "velocity" in joint.commands
            and joint.name in self.tree.joints
            and self.tree.joints[joint.name].type == "continuous"
        )

    def part_of(self, link: str) -> Part:
        """Return the part of a link."""
        return next(part for part in self.parts if link in part.members)


class GazeboPlace(NamedTuple):
    """Place of a robot in a world of Gazebo, on which the names of its topics depend."""

    name: str  #: name of the robot
    world: str  #: name of the world
    namespace: str = ""  #: namespace of its topics


def read_robot(text: str, place: GazeboPlace | None = None) -> RobotModel:
    """Return the robot that a URDF text describes.

    Args:
        text: The description.
        place: If given, the robot has the topics that its description names, as in Gazebo.
            Otherwise, it has zbot's usual topics and sensors.

    Raises:
        DescriptionError: The text is not a valid description.
        SimulationError: The robot cannot be simulated, e.g. because it is too large.
    """
    tree = read_urdf(text)
    solids = read_appearance(text, "collision")
    check_size(tree, solids)
    parts = parts_of(tree)
    equipment = _equipment(text, tree, parts, solids, place)
    # Gazebo connects a root with this name with the world.
    is_fixed = tree.root == "world"
    controlled = () if equipment.control is None else controlled_joints(text)
    inertia = read_inertia(text)
    is_gazebo = place is not None
    return RobotModel(
        text, tree, solids, inertia, parts, equipment, is_fixed, controlled, is_gazebo
    )


def check_size(tree: Robot, solids: Solids) -> None:
    """Refuse a robot that is too large.

    Raises:
        SimulationError: It has too many links, joints or solids.
    """
    check_links(len(tree.links))
    moving = sum(joint.type in MOVING for joint in tree.joints.values())
    for count, most, what in (
        (moving, _MOST_MOVING, "joints that move"),
        (sum(map(len, solids.values())), _MOST_SOLIDS, "<collision> tags"),
    ):
        if count > most:
            raise SimulationError(f"the robot has {count} {what}: the limit is {most}")


def check_links(count: int) -> None:
    """Refuse a robot with too many links.

    Raises:
        SimulationError: There are more than the limit.
    """
    if count > _MOST_LINKS:
        raise SimulationError(f"the robot has {count} links: the limit is {_MOST_LINKS}")


def parts_of(tree: Robot) -> tuple[Part, ...]:
    """Return the parts of a robot: the links that fixed joints connect move together."""
    children: dict[str, list[Joint]] = {}
    for joint in tree.joints.values():
        children.setdefault(joint.parent, []).append(joint)
    parts = [Part(tree.root, None, {tree.root: Rigid()})]
    for part in parts:  # it grows in the loop
        waiting = [part.link]
        while waiting:
            link = waiting.pop()
            for joint in children.get(link, ()):
                if joint.type in MOVING:
                    parts.append(Part(joint.child, joint, {joint.child: Rigid()}))
                else:
                    part.members[joint.child] = part.members[link] @ joint.origin
                    waiting.append(joint.child)
    return tuple(parts)


def poses_of(parts: tuple[Part, ...]) -> dict[str, Rigid]:
    """Return the pose of each link in the root, with all joints at 0."""
    found: dict[str, Rigid] = {}
    for part in parts:
        joint = part.joint
        start = Rigid() if joint is None else found[joint.parent] @ joint.origin
        found.update((link, start @ pose) for link, pose in part.members.items())
    return found


def _equipment(
    text: str, tree: Robot, parts: tuple[Part, ...], solids: Solids, place: GazeboPlace | None
) -> Equipment:
    if place is not None:
        names = GazeboNames(place.name, place.world, lumped_links(text, tree), place.namespace)
        return fitted(read_equipment(urdf_tags(text), names, tree.root), tree, parts, solids)
    found = read_equipment(urdf_tags(text), PlainNames(), tree.root)
    if found.control is not None:
        notices = (*found.notices, "the controller manager in the simulator")
        found = replace(found, control=None, notices=notices)
    drive = found.drive or find_drive(tree, poses_of(parts), solids)
    friction = {link: 0.0 for link in tree.links if "caster" in link.lower()} | found.friction
    found = fitted(replace(found, drive=drive, friction=friction), tree, parts, solids)
    return found if found.sensors else replace(found, sensors=find_sensors(tree))


def fitted(equipment: Equipment, tree: Robot, parts: tuple[Part, ...], solids: Solids) -> Equipment:
    """Return equipment with the measures that a description leaves out, and fit it to parts.

    Raises:
        SimulationError: The drive names a joint that does not exist, or lacks a measure.
    """
    for mount, (link, pose) in equipment.mounts.items():
        part = next((part for part in parts if link in part.members), None)
        if part is not None:
            part.members[mount] = part.members[link] @ pose
    drive = equipment.drive
    if drive is not None:
        drive = complete(drive, tree, poses_of(parts), solids)
        if not drive.base_frame:
            drive = replace(drive, base_frame=tree.root)
    known = {link for part in parts for link in part.members}
    sensors = tuple(sensor for sensor in equipment.sensors if sensor.link in known)
    return replace(equipment, drive=drive, sensors=sensors)
