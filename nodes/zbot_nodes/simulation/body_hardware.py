"""Hardware of ros2_control that is a robot in the simulator."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from zbot.simulation.robots.equipment import Imu
from zbot.simulation.sensors.imu import InertialSensor
from zbot_nodes.control.hardware import POSITION, VELOCITY, Component, SimulatedHardware

if TYPE_CHECKING:
    from zbot.libraries.robot_description.urdf import Mimic
    from zbot.simulation.robots.joint_motors import Kind
    from zbot.simulation.robots.robot import Robot
    from zbot.simulation.world import World

_EFFORT = "effort"
#: If a joint has several commands, the first kind in this order moves it.
_ORDER: tuple[Kind, ...] = ("position", "velocity", "effort")


class BodyHardware(SimulatedHardware):
    """Hardware whose states are those of a robot's joints, and whose commands move them.

    As in Gazebo, a joint that no controller commands holds its position.

    Args:
        components: The components of the robot.
        mimics: Joints that follow other joints.
        robot: The robot in the simulator.
        world: The world of the robot.
    """

    def __init__(
        self, components: list[Component], mimics: dict[str, Mimic], robot: Robot, world: World
    ) -> None:
        super().__init__(components, mimics)
        self._robot, self._world = robot, world
        sensors = robot.model.equipment.sensors
        imu = next((sensor for sensor in sensors if isinstance(sensor, Imu)), None)
        self._imu = None if imu is None else InertialSensor(imu, robot, len(sensors))
        inertial = (name for name in self.states if name.endswith("/orientation.x"))
        self._imu_names = [name.partition("/")[0] for name in inertial]
        self.active_commands: set[str] = set()  #: command interfaces of active controllers
        self._held: dict[str, float] = {
            joint.name: joint.start for joint in robot.model.controlled if joint.start is not None
        }

    def read(self, period_s: float) -> None:  # noqa: ARG002 - the base class has it
        """Read the joints."""
        rows = zip(*self._robot.joint_states(), strict=True)
        for joint, position, velocity in rows:
            effort = self._robot.joint_motors.effort(joint)
            for kind, value in ((POSITION, position), (VELOCITY, velocity), (_EFFORT, effort)):
                if f"{joint}/{kind}" in self.states:
                    self.states[f"{joint}/{kind}"] = value
        for component in self.components:
            self._follow_others(component)
        self._read_imu()

    def _read_imu(self) -> None:
        if self._imu is None or not self._imu_names:
            return
        reading = self._imu.measure(self._world)
        for name in self._imu_names:
            for kind, values in (
                ("orientation", reading.orientation),
                ("angular_velocity", reading.turn),
                ("linear_acceleration", reading.acceleration),
            ):
                for axis, value in zip("xyzw", values, strict=False):
                    self.states[f"{name}/{kind}.{axis}"] = float(value)

    def write(self) -> None:
        """Command the joints."""
        motors = self._robot.joint_motors
        for component in self.components:
            is_active = self.component_states[component.name] == "active"
            for joint in component.joints:
                found = self._command_of(joint) if is_active else None
                if found is not None:
                    self._held.pop(joint, None)
                    motors.command(joint, *found)
                elif self._is_moved(joint):
                    at = self.states.get(f"{joint}/{POSITION}", 0.0)
                    motors.command(joint, "position", self._held.setdefault(joint, at))
                else:
                    motors.release(joint)

    def _command_of(self, joint: str) -> tuple[Kind, float] | None:
        for kind in _ORDER:
            name = f"{joint}/{kind}"
            value = self.commands.get(name, math.nan)
            if name in self.active_commands and math.isfinite(value):
                return kind, value
        return None

    def _is_moved(self, joint: str) -> bool:
        """Return whether controllers can give a joint a position or a velocity."""
        return not {f"{joint}/{POSITION}", f"{joint}/{VELOCITY}"}.isdisjoint(self.commands)
