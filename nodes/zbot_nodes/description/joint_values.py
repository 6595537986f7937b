"""Values of the joints of a robot that no hardware measures: positions, velocities, efforts."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from zbot.libraries.robot_description.urdf import MOVING, Mimic
from zbot.libraries.robot_description.xml_text import DescriptionError

if TYPE_CHECKING:
    from collections.abc import Mapping

    from zbot.libraries.robot_description.urdf import Joint, Robot

    from sensor_msgs.msg import JointState


@dataclass
class JointValue:
    """Values of one joint. Angles are in rad, distances in metres. None means not known."""

    lower: float
    upper: float
    zero: float
    is_continuous: bool = False
    is_angle: bool = True
    position: float | None = None
    velocity: float | None = None
    effort: float | None = None
    forward: bool = True  #: whether `advance` moves the joint towards `upper`

    def advance(self, delta: float) -> None:
        """Move by `delta`. At a limit, change the direction. A continuous joint goes on."""
        position = (self.position or 0.0) + (delta if self.forward else -delta)
        if position > self.upper and self.is_continuous:
            position = self.lower
        elif not self.lower <= position <= self.upper:
            position = min(max(position, self.lower), self.upper)
            self.forward = not self.forward
        self.position = position


@dataclass(frozen=True)
class Defaults:
    """Settings of joint_state_publisher, as documented for its parameters."""

    positions: bool = True
    velocities: bool = False
    efforts: bool = False
    use_mimic: bool = True
    use_soft_limits: bool = True


class JointValues:
    """Values of all moving joints of a robot.

    Args:
        robot: The robot.
        defaults: Which values the joints have at the start.
        zeros: Positions at the start, by joint.
        dependent: Rules of joints that follow other joints. They override the description's rules.

    Raises:
        DescriptionError: A joint follows an unknown joint, or joints follow each other.
    """

    def __init__(
        self,
        robot: Robot,
        defaults: Defaults,
        zeros: Mapping[str, float],
        dependent: Mapping[str, Mimic],
    ) -> None:
        moving = {name: joint for name, joint in robot.joints.items() if joint.type in MOVING}
        self.names = tuple(moving)
        own = {name: joint.mimic for name, joint in moving.items() if joint.mimic}
        rules = {**(own if defaults.use_mimic else {}), **dependent}
        self.free = {
            name: _value(joint, defaults, zeros.get(name))
            for name, joint in moving.items()
            if name not in rules
        }
        #: For each moving joint, the rule by which it follows a free joint. A free joint follows
        #: itself.
        self._sources = {name: self._source(name, rules) for name in moving}
        self._has_dependent = any(name in rules for name in moving)

    def _source(self, name: str, rules: Mapping[str, Mimic]) -> Mimic:
        found = Mimic(name)
        for _ in range(len(rules) + 1):
            if found.joint not in rules:
                break
            rule = rules[found.joint]
            offset = found.offset + found.multiplier * rule.offset
            found = Mimic(rule.joint, found.multiplier * rule.multiplier, offset)
        else:
            raise DescriptionError(f"joint '{name}' mimics itself through other joints")
        if found.joint not in self.free:
            raise DescriptionError(f"joint '{name}' mimics '{found.joint}', which does not move")
        return found

    def take(self, message: JointState) -> None:
        """Use the values of a message. The message's lists may be empty or too short."""
        lists = (message.position, message.velocity, message.effort)
        for index, name in enumerate(message.name):
            joint = self.free.get(name)
            if joint is None:
                continue
            position, velocity, effort = (
                values[index] if index < len(values) else None for values in lists
            )
            joint.position = joint.position if position is None else position
            joint.velocity = joint.velocity if velocity is None else velocity
            joint.effort = joint.effort if effort is None else effort

    def advance(self, delta: float) -> None:
        """Move every joint by `delta`."""
        for joint in self.free.values():
            joint.advance(delta)

    def fill(self, message: JointState) -> None:
        """Write the values into a message. A list stays empty if no joint has such a value."""
        message.name = list(self.names)
        rules = [(self._sources[name], self.free[self._sources[name].joint]) for name in self.names]
        free = self.free.values()
        if self._has_dependent or any(joint.position is not None for joint in free):
            message.position = [
                rule.multiplier * joint.position + rule.offset
                if joint.position is not None
                else 0.0
                for rule, joint in rules
            ]
        if any(joint.velocity is not None for joint in free):
            message.velocity = [rule.multiplier * (joint.velocity or 0.0) for rule, joint in rules]
        if any(joint.effort is not None for joint in free):
            message.effort = [joint.effort or 0.0 for _, joint in rules]


def _value(joint: Joint, defaults: Defaults, zero: float | None) -> JointValue:
    lower, upper = joint.lower, joint.upper
    if joint.type == "continuous":
        lower, upper = -math.pi, math.pi
    if defaults.use_soft_limits:
        lower = max(lower, lower if joint.soft_lower is None else joint.soft_lower)
        upper = min(upper, upper if joint.soft_upper is None else joint.soft_upper)
    if zero is None:
        zero = (lower + upper) / 2 if lower > 0 or upper < 0 else 0.0
    return JointValue(
        lower,
        upper,
        zero,
        joint.type == "continuous",
        joint.type != "prismatic",
        zero if defaults.positions else None,
        0.0 if defaults.velocities else None,
        0.0 if defaults.efforts else None,
    )
