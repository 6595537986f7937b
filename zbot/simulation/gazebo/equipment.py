"""Equipment that the tags of Gazebo name, in a robot description or in SDF."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from zbot.libraries.robot_description.xml_text import read_xml
from zbot.simulation.gazebo.plugins import read_plugins
from zbot.simulation.gazebo.sensors import Mounted, read_sensor
from zbot.simulation.gazebo.tags import first, flag, number
from zbot.simulation.gazebo.unused import unused_notice, unused_tags
from zbot.simulation.robots.equipment import MODEL_FRAME, Equipment, Sensor
from zbot.tf2.rigid import Rigid

if TYPE_CHECKING:
    from collections.abc import Sequence
    from xml.etree.ElementTree import Element

    from zbot.libraries.robot_description.urdf import Robot
    from zbot.simulation.gazebo.names import Names


class GazeboTags(NamedTuple):
    """Tags of one robot for Gazebo."""

    sensors: Sequence[Mounted]
    plugins: Sequence[Element]
    friction: dict[str, float]  #: by link
    unused: frozenset[str] = frozenset()  #: tags that have no effect


def urdf_tags(text: str) -> GazeboTags:
    """Return what the `<gazebo>` tags of a robot description contain.

    Raises:
        DescriptionError: The text is not XML, or a value is not a number.
    """
    sensors: list[Mounted] = []
    plugins: list[Element] = []
    friction: dict[str, float] = {}
    unused: set[str] = set()
    for tag in read_xml(text).findall("gazebo"):
        link = tag.get("reference", "")
        if first(tag, "mu1", "mu") is not None:
            friction[link] = number(tag, 0.0, "mu1", "mu")
        unused |= unused_tags(tag)
        sensors += [Mounted(link, element) for element in tag.findall("sensor")]
        plugins += tag.findall("plugin")
    return GazeboTags(sensors, plugins, friction, frozenset(unused))


def lumped_links(text: str, tree: Robot) -> dict[str, str]:
    """Return, for each link, the link that Gazebo makes it a part of.

    Gazebo leaves out fixed joints, unless a tag preserves them.
    """
    kept = set()
    for tag in read_xml(text).findall("gazebo"):
        if flag(tag, False, "preserveFixedJoint", "disableFixedJointLumping"):
            kept.add(tag.get("reference", ""))
    above = {
        joint.child: joint.parent
        for joint in tree.joints.values()
        if joint.type == "fixed" and joint.name not in kept and joint.parent != "world"
    }
    found = {}
    for link in tree.links:
        at = link
        while at in above:
            at = above[at]
        found[link] = at
    return found


def read_equipment(
    tags: GazeboTags, names: Names, root: str, model_in_root: Rigid | None = None
) -> Equipment:
    """Return the equipment that tags name. Its drive may lack measures.

    Args:
        tags: The tags.
        names: The names of the topics and frames.
        root: The root link of the robot.
        model_in_root: The frame of the model in the root, if they are not the same.

    Raises:
        DescriptionError: A value is not valid.
    """
    plugins = read_plugins(tags.plugins, names, root)
    sensors: list[Sensor] = []
    notices = unused_notice(tags.unused)
    mounts = {}
    if plugins.poses or plugins.link_poses:
        mounts[MODEL_FRAME] = (root, model_in_root or Rigid())
    for mounted in tags.sensors:
        read = read_sensor(mounted, names)
        if isinstance(read, str):
            notices.append(read)
            continue
        sensors += read
        if mounted.mount != mounted.link:
            mounts[mounted.mount] = (mounted.link, mounted.pose)
    return Equipment(
        plugins.drive,
        (*sensors, *(plugins.poses if names.model else ())),
        tags.friction,
        tuple(dict.fromkeys([*plugins.notices, *notices])),
        mounts,
        tuple(plugins.joint_states) if names.model else (),
        tuple(plugins.joint_commands),
        tuple(plugins.link_poses) if names.model else (),
        plugins.control,
    )
