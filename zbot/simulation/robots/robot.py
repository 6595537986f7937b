"""Robot in a world: its bodies, its pose, and the positions of its joints."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.libraries.robot_description.urdf import MOVING
from zbot.simulation.free_body import FreeBody
from zbot.simulation.robots.arm import ArmMotors, add_arm, arm_joints
from zbot.simulation.robots.bodies import add_bodies
from zbot.simulation.robots.joint_motors import JointMotors
from zbot.simulation.robots.motors import add_motors, motors_of
from zbot.simulation.rotation import to_matrix
from zbot.tf2.rigid import Rigid

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from zbot.simulation.robots.model import RobotModel

    Array = NDArray[np.float64]


class Robot(FreeBody):
    """Robot that is in a world.

    Args:
        name: Its name among the entities of the world.
        model: Its description.
        pose: Where its root starts, in the world.
        number: Its number in the world.

    Attributes:
        command: The wanted velocity: forward and to the left in m/s, and the turn in rad/s.
        notices: What the simulator leaves out of the description.
        arm: The motors of its arm, if it is one.
    """

    def __init__(self, name: str, model: RobotModel, pose: Rigid, number: int) -> None:
        super().__init__(name)
        self.model, self.start, self.number = model, pose, number
        self.prefix = f"{name}/"
        self.command = (0.0, 0.0, 0.0)
        self.notices: list[str] = []
        self.joints = [joint.name for joint in model.tree.joints.values() if joint.type in MOVING]
        self.arm = ArmMotors(model) if arm_joints(model) else None
        self.motors = self.arm or motors_of(model)
        self.joint_motors = JointMotors(model)

    def add_to(self, spec: Any) -> None:
        """Add the bodies and the motors to a world."""
        self.notices = add_bodies(spec, self.prefix, self.model, self.start, self.number)
        self.notices += self.model.equipment.notices
        add_motors(spec, self.prefix, self.model)
        add_arm(spec, self.prefix, self.model)
        self.joint_motors.add_to(spec, self.prefix)

    def remove_from(self, spec: Any) -> None:
        """Remove the robot from a world, also if only some of its parts are there."""
        for item in [*spec.actuators, *spec.equalities]:
            if item.name.startswith(self.prefix):
                spec.delete(item)
        root = spec.body(self.prefix + self.model.tree.root)
        if root is not None:
            spec.delete(root)

    def bind(self, model: Any, data: Any) -> None:
        """Find the robot's numbers in a new compiled world."""
        self.bind_root(model, data, model.body(self.prefix + self.model.tree.root).id)
        self.geoms = np.flatnonzero(model.body_rootid[model.geom_bodyid] == self.root)
        found = [model.joint(self.prefix + name).id for name in self._moving()]
        self._angles, self._rates = model.jnt_qposadr[found], model.jnt_dofadr[found]
        self._geoms_by_link: dict[str, list[int]] = {}
        for geom in self.geoms.tolist():
            link = model.geom(geom).name.removeprefix(self.prefix).rpartition("#")[0]
            self._geoms_by_link.setdefault(link, []).append(geom)
        self.motors.bind(model, self.prefix)
        self.joint_motors.bind(model, data, self.prefix)

    def _moving(self) -> list[str]:
        joints = self.model.tree.joints
        return [name for name in self.joints if any(joints[name].axis)]

    def stand_on(self, height: float) -> None:
        """Lift the robot, so that its lowest point is at a height. It starts there from now on."""
        boxes = self._model.geom_aabb[self.geoms]
        turns = self._data.geom_xmat[self.geoms].reshape(-1, 3, 3)[:, 2]
        middles = self._data.geom_xpos[self.geoms, 2] + (turns * boxes[:, :3]).sum(axis=1)
        lowest = (middles - (np.abs(turns) * boxes[:, 3:]).sum(axis=1)).min(initial=np.inf)
        if math.isfinite(lowest):
            x, y, z = self.pose.translation
            self.start = Rigid((x, y, z + height - float(lowest)), self.pose.rotation)
            self.pose = self.start

    def stop(self) -> None:
        """Let all parts of the robot stand still."""
        super().stop()
        self._data.qvel[self._rates] = 0
        self.command = (0.0, 0.0, 0.0)

    def geoms_of(self, link: str) -> list[int]:
        """Return the numbers of the solids of a link in the compiled world."""
        return self._geoms_by_link.get(link, [])

    def joint_states(self) -> tuple[list[str], list[float], list[float]]:
        """Return the names, the positions and the velocities of the joints that move."""
        return (
            self._moving(),
            self._data.qpos[self._angles].tolist(),
            self._data.qvel[self._rates].tolist(),
        )

    def link_pose(self, link: str) -> Rigid:
        """Return the pose of a link in the world."""
        part = self.model.part_of(link)
        if part.joint is None:
            return self.pose @ part.members[link]
        body = self._model.body(self.prefix + part.link).id
        qw, qx, qy, qz = self._data.xquat[body].tolist()
        x, y, z = self._data.xpos[body].tolist()
        return Rigid((x, y, z), (qx, qy, qz, qw)) @ part.members[link]

    def link_velocity(self, link: str) -> tuple[Array, Array]:
        """Return the velocity of a link and its turn, in the world's frame."""
        linear, angular = self.velocity
        turn, pose = to_matrix(self.pose), self.pose
        away = np.array(pose.inverse().apply(self.link_pose(link).translation))
        moved: Array = linear + np.cross(angular, away)
        return turn @ moved, turn @ angular

    def drive(self) -> None:
        """Give the motors their commands for one step."""
        self.motors.drive(self, self._data)
        self.joint_motors.drive()
