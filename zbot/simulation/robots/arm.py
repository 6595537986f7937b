"""Arm of a robot: its joints, and the motors that hold their positions."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.libraries.robot_description.urdf import MOVING
from zbot.simulation.engine import STEP_S, engine
from zbot.simulation.robots.motors import Motors

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from zbot.libraries.robot_description.urdf import Joint
    from zbot.simulation.robots.model import RobotModel
    from zbot.simulation.robots.motors import DrivenRobot

#: A motor has its full strength at this error, in radians or metres.
_FULL_ERROR = 0.05
_USUAL_EFFORT = 10.0
#: How fast the wanted position moves, in rad/s or m/s, if a command has no time.
_SPEED = 1.5


def arm_joints(model: RobotModel) -> list[Joint]:
    """Return the joints of an arm: all with limits, if nothing else moves the robot's joints."""
    joints = model.tree.joints.values()
    if model.is_gazebo or model.controlled or model.equipment.drive is not None:
        return []
    moves = [joint for joint in joints if joint.type in MOVING and any(joint.axis)]
    return [joint for joint in moves if joint.type != "continuous" and joint.lower < joint.upper]


def add_arm(spec: Any, prefix: str, model: RobotModel) -> None:
    """Add a motor to each joint of an arm. The motors also carry the weight of the arm."""
    for joint in arm_joints(model):
        effort = joint.effort if math.isfinite(joint.effort) else _USUAL_EFFORT
        name = prefix + joint.name
        motor = spec.add_actuator(name=name, target=name, trntype=engine().mjtTrn.mjTRN_JOINT)
        motor.set_to_position(kp=effort / _FULL_ERROR, dampratio=1.0)
        motor.forcelimited, motor.forcerange = 1, (-effort, effort)
        # A motor with a gear is heavy to turn. Without this, the joint would tremble.
        spec.joint(name).armature = effort * 1e-3
        spec.body(prefix + model.part_of(joint.child).link).gravcomp = 1.0


class ArmMotors(Motors):
    """Motors that hold positions.

    Args:
        model: The robot.

    Attributes:
        names: The joints.
        wanted: The positions that the motors shall reach, in radians or metres.
    """

    def __init__(self, model: RobotModel) -> None:
        joints = arm_joints(model)
        self.names = [joint.name for joint in joints]
        self._low = np.array([joint.lower for joint in joints])
        self._high = np.array([joint.upper for joint in joints])
        self.wanted: NDArray[np.float64] = np.clip(np.zeros(len(joints)), self._low, self._high)
        self._now = self.wanted.copy()
        self._way: list[tuple[float, NDArray[np.float64]]] = []
        self._passed_s = 0.0

    def reset(self) -> None:
        """Go back to the positions at the start."""
        self.wanted = np.clip(np.zeros(len(self.names)), self._low, self._high)
        self._now = self.wanted.copy()
        self._way.clear()

    def bind(self, model: Any, prefix: str) -> None:
        """Find the motors."""
        self._controls = np.array([model.actuator(prefix + name).id for name in self.names])

    def go(self, positions: Sequence[float]) -> None:
        """Go to positions, as fast as the motors can."""
        self._way.clear()
        self.wanted = np.clip(np.array(positions), self._low, self._high)

    def follow(self, points: Sequence[tuple[float, Sequence[float]]]) -> None:
        """Follow a way from the present positions.

        Args:
            points: Seconds from now, and the positions at that time. The seconds grow.
        """
        self._passed_s = 0.0
        self._way = [(0.0, self._now.copy())]
        self._way += [(at_s, np.clip(np.array(to), self._low, self._high)) for at_s, to in points]
        self.wanted = self._way[-1][1]

    def drive(self, robot: DrivenRobot, data: Any) -> None:  # noqa: ARG002 - the base class has it
        """Give the motors their positions for one step."""
        if self._way:
            self._passed_s += STEP_S
            times = [at_s for at_s, _ in self._way]
            columns = np.array([to for _, to in self._way]).T
            self._now = np.array([np.interp(self._passed_s, times, column) for column in columns])
            if self._passed_s >= times[-1]:
                self._way.clear()
        else:
            most = _SPEED * STEP_S
            self._now = self._now + np.clip(self.wanted - self._now, -most, most)
        data.ctrl[self._controls] = self._now
