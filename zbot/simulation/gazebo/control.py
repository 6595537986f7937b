"""Reader of the joints in `<ros2_control>` tags, which a controller manager reads and commands."""

from __future__ import annotations

from dataclasses import dataclass

from zbot.libraries.robot_description.xml_text import numbers, read_xml


@dataclass(frozen=True)
class ControlledJoint:
    """Joint of a `<ros2_control>` tag."""

    name: str
    commands: frozenset[str]  #: kinds of its commands, e.g. `velocity`
    start: float | None = None  #: its first position


def controlled_joints(text: str) -> tuple[ControlledJoint, ...]:
    """Return the joints that the `<ros2_control>` tags of a robot description name.

    Raises:
        DescriptionError: The text is not XML, or a value is not a number.
    """
    found = []
    for joint in read_xml(text).iterfind("ros2_control/joint"):
        commands = {entry.get("name", "") for entry in joint.findall("command_interface")}
        start = joint.find("state_interface[@name='position']/param[@name='initial_value']")
        value = (start.text or "").strip() if start is not None else ""
        first = numbers(value, 1, "initial_value")[0] if value else None
        found.append(ControlledJoint(joint.get("name", ""), frozenset(commands), first))
    return tuple(found)
