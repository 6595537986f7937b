"""Simulated hardware of a robot, with the interfaces in <ros2_control> of its description."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from zbot.libraries.robot_description.urdf import read_urdf
from zbot.libraries.robot_description.xml_text import DescriptionError, numbers, read_xml

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

    from zbot.libraries.robot_description.urdf import Mimic

#: ROS 2's plugins for simulated hardware. This module behaves as their documentation says.
MOCKS = frozenset({"mock_components/GenericSystem", "fake_components/GenericSystem"})
_KINDS = ("system", "actuator", "sensor")
_PARTS = ("joint", "sensor", "gpio")
_TRUE = frozenset({"true", "1", "yes"})
#: States of a component. The numbers are those of lifecycle_msgs/State.
COMPONENT_STATES = {1: "unconfigured", 2: "inactive", 3: "active", 4: "finalized"}
POSITION, VELOCITY, ACCELERATION = "position", "velocity", "acceleration"


@dataclass(frozen=True)
class Component:
    """A <ros2_control> tag. Interfaces have names such as `left_wheel/velocity`."""

    name: str
    kind: str  #: `system`, `actuator` or `sensor`
    plugin: str
    parameters: dict[str, str] = field(default_factory=dict)
    joints: tuple[str, ...] = ()
    commands: tuple[str, ...] = ()  #: names of the command interfaces
    states: dict[str, float] = field(default_factory=dict)  #: state interfaces, initial values

    @property
    def is_mock(self) -> bool:
        """Whether the plugin is one of ROS 2's plugins for simulated hardware."""
        return self.plugin in MOCKS

    def number(self, name: str) -> float:
        """Return a parameter as a number, or 0 if the parameter is not set."""
        text = self.parameters.get(name, "0")
        return numbers(text, 1, f"the parameter {name} of the hardware '{self.name}'")[0]

    def is_set(self, name: str) -> bool:
        """Return whether a parameter is set to true."""
        return self.parameters.get(name, "").strip().lower() in _TRUE


def read_components(description: str) -> list[Component]:
    """Return the hardware components of a robot description.

    Raises:
        DescriptionError: The description or one of its <ros2_control> tags is not valid.
    """
    read_urdf(description)  # raises an error if the rest of the description is not valid
    found = [_component(element) for element in read_xml(description).findall("ros2_control")]
    for name, count in Counter(component.name for component in found).items():
        if count > 1:
            raise DescriptionError(f"two <ros2_control> tags have the name '{name}'")
    return found


def _component(element: Element) -> Component:
    name, kind = element.get("name", ""), element.get("type", "")
    if not name:
        raise DescriptionError("a <ros2_control> has no name")
    if kind not in _KINDS:
        raise DescriptionError(f"<ros2_control> '{name}' has the type '{kind[:40]}', not system")
    plugin = (element.findtext("hardware/plugin") or "").strip()
    if not plugin:
        raise DescriptionError(f"<ros2_control> '{name}' has no <hardware><plugin>")
    parts = [part for tag in _PARTS for part in element.findall(tag)]
    commands: list[str] = []
    states: dict[str, float] = {}
    for part in parts:
        owner = _named(part, name)
        commands += [
            f"{owner}/{_named(element, owner)}" for element in part.findall("command_interface")
        ]
        for interface in part.findall("state_interface"):
            states[f"{owner}/{_named(interface, owner)}"] = _initial(interface, owner)
    joints = tuple(part.get("name", "") for part in element.findall("joint"))
    hardware = element.find("hardware")
    parameters = _parameters(hardware) if hardware is not None else {}
    return Component(name, kind, plugin, parameters, joints, tuple(commands), states)


def _named(element: Element, owner: str) -> str:
    name = element.get("name", "").strip()
    if not name:
        raise DescriptionError(f"a <{element.tag[:40]}> of '{owner}' has no name")
    return name


def _parameters(element: Element) -> dict[str, str]:
    return {
        parameter.get("name", ""): (parameter.text or "").strip()
        for parameter in element.findall("param")
    }


def _initial(element: Element, owner: str) -> float:
    text = _parameters(element).get("initial_value", "") or "0"
    return numbers(text, 1, f"initial_value of '{owner}'")[0]


class SimulatedHardware:
    """Hardware in which each state becomes equal to the command of the same name.

    With the parameter `calculate_dynamics`, and for every plugin that is not a mock, a commanded
    velocity moves the position too. Only active components move.

    Args:
        components: The components of the robot.
        mimics: Joints that follow other joints.
    """

    def __init__(self, components: list[Component], mimics: dict[str, Mimic]) -> None:
        self.components = components
        self.states = {
            name: at for component in components for name, at in component.states.items()
        }
        #: Commands by interface. NaN means that no controller has commanded yet.
        self.commands = dict.fromkeys(
            (n for component in components for n in component.commands), math.nan
        )
        self.component_states = {component.name: "active" for component in components}
        self._mimics = mimics

    def set_component_state(self, name: str, state: str) -> None:
        """Change the state of a component. One that becomes active waits for new commands."""
        if state == "active" != self.component_states[name]:
            own = (
                command
                for component in self.components
                if component.name == name
                for command in component.commands
            )
            self.commands.update(dict.fromkeys(own, math.nan))
        self.component_states[name] = state

    def closed(self) -> dict[str, str]:
        """Return the interfaces of components that are not configured, with their components."""
        return {
            interface: component.name
            for component in self.components
            if self.component_states[component.name] not in {"inactive", "active"}
            for interface in (*component.commands, *component.states)
        }

    def add(self, commands: list[str], states: list[str]) -> None:
        """Add the interfaces of a controller. Other controllers use them."""
        self.commands.update(dict.fromkeys(commands, math.nan))
        self.states.update(dict.fromkeys(states, math.nan))

    def remove(self, commands: list[str], states: list[str]) -> None:
        """Remove the interfaces of a controller."""
        for name in commands:
            del self.commands[name]
        for name in states:
            del self.states[name]

    def read(self, period_s: float) -> None:
        """Move everything for one period."""
        for component in self.components:
            is_active = self.component_states[component.name] == "active"
            if not is_active or component.is_set("disable_commands"):
                continue
            has_dynamics = component.is_set("calculate_dynamics") or not component.is_mock
            offset = component.number("position_state_following_offset")
            for joint in component.joints:
                if has_dynamics:
                    self._move(joint, period_s)
                self._follow(component, joint, offset)
            self._follow_others(component)
        self._move_mimics()

    def _move(self, joint: str, period_s: float) -> None:
        """Integrate a commanded acceleration or velocity; differentiate a commanded position."""
        states = self.states
        position, velocity = f"{joint}/{POSITION}", f"{joint}/{VELOCITY}"
        commands = {kind: self._command(f"{joint}/{kind}") for kind in _ORDER}
        kind = next((kind for kind in _ORDER if commands[kind] is not None), None)
        command = commands[kind] if kind is not None else None
        if command is None or period_s <= 0:
            return
        if kind == POSITION:
            if velocity in states and f"{joint}/{VELOCITY}" not in self.commands:
                states[velocity] = (command - states.get(position, command)) / period_s
            return
        speed = command
        if kind == ACCELERATION:
            speed = states.get(velocity, 0.0) + command * period_s
            states[velocity] = speed
        if position in states:
            states[position] += speed * period_s

    def _follow(self, component: Component, joint: str, offset: float) -> None:
        for kind in (POSITION, VELOCITY, ACCELERATION, "effort"):
            name = f"{joint}/{kind}"
            command = self._command(name)
            if command is not None and name in component.states:
                self.states[name] = command + (offset if kind == POSITION else 0.0)

    def _follow_others(self, component: Component) -> None:
        """Copy the commands of gpio outputs and of other non-standard interfaces to the states."""
        joints = {f"{joint}/{kind}" for joint in component.joints for kind in _STANDARD}
        for name in component.commands:
            command = self._command(name)
            if name not in joints and name in component.states and command is not None:
                self.states[name] = command

    def _move_mimics(self) -> None:
        for joint, mimic in self._mimics.items():
            for kind in (POSITION, VELOCITY, ACCELERATION):
                other, own = f"{mimic.joint}/{kind}", f"{joint}/{kind}"
                if own in self.states and other in self.states and own not in self.commands:
                    offset = mimic.offset if kind == POSITION else 0.0
                    self.states[own] = mimic.multiplier * self.states[other] + offset

    def _command(self, name: str) -> float | None:
        command = self.commands.get(name, math.nan)
        return command if math.isfinite(command) else None


#: If a joint has several commands, the first kind in this order moves the joint.
_ORDER = (ACCELERATION, VELOCITY, POSITION)
_STANDARD = (POSITION, VELOCITY, ACCELERATION, "effort")
