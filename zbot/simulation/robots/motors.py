"""Motors of robots: they turn a wanted velocity into speeds of wheels, and measure it back."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from zbot.simulation.engine import STEP_S, engine
from zbot.simulation.rotation import to_matrix
from zbot.tf2.rigid import rotate

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from zbot.simulation.robots.equipment import Drive
    from zbot.simulation.robots.model import RobotModel
    from zbot.tf2.rigid import Rigid

    Array = NDArray[np.float64]
    #: Forward and to the left in metres, and the turn in radians.
    Way = tuple[float, float, float]

_GRAVITY_M_S2 = 9.81
#: Inertia of a motor seen at its wheel, as a share of the mass on the wheel.
_ROTOR_SHARE = 0.2
#: How hard a motor holds its speed, in 1/s. Larger values let the wheels tremble.
_STIFFNESS_S = 56.0

#: Time in which sliding wheels bring the robot to their velocity, if the floor holds them.
_GRIP_S = 0.03
_STEERING_RATE = 4.0  # rad/s
_STEERING_ARM_M = 0.1
#: Time in which a motor that holds a position reaches it.
_SERVO_S = 0.03
#: A motor that cannot hold its joint against this error has a placeholder for its effort.
_LEAST_ANGLE = 0.01
#: Largest change of the turn, in rad/s, for a change of the velocity of 1 m/s.
_TURN_SHARE = 5.0


class DrivenRobot(Protocol):
    """The part of a robot that its motors use."""

    command: tuple[float, float, float]
    root: int

    @property
    def pose(self) -> Rigid:
        """The pose of the root in the world."""
        ...

    @property
    def velocity(self) -> tuple[Array, Array]:
        """The velocity and the turn of the root, in its own frame."""
        ...


class Motors:
    """No motors: the robot stands, and its joints move freely."""

    def bind(self, model: Any, prefix: str) -> None:
        """Find the motors' numbers in a new compiled world."""

    def reset(self) -> None:
        """Stand still."""

    def drive(self, robot: DrivenRobot, data: Any) -> None:
        """Give the motors their commands for one step."""

    def travelled(self, robot: DrivenRobot, data: Any) -> Way:  # noqa: ARG002 - subclasses use them
        """Return the way since the last call, as the wheels tell it."""
        return (0.0, 0.0, 0.0)


class WheelMotors(Motors):
    """Motors of left and right wheels, whose difference steers the robot."""

    def __init__(self, drive: Drive) -> None:
        self.spec = drive
        self._now = (0.0, 0.0)  # the velocity and the turn that the wheels shall have
        self._angles: Array | None = None  # of the wheels at the last measurement
        count = len(drive.left)
        self._sides = np.array([-1.0] * count + [1.0] * len(drive.right))
        self._signs = np.array(drive.signs or [1.0] * len(self._sides))

    def reset(self) -> None:
        """Stand still."""
        self._now = (0.0, 0.0)
        self._angles = None

    def bind(self, model: Any, prefix: str) -> None:
        """Find the wheels."""
        wheels = [prefix + name for name in (*self.spec.left, *self.spec.right)]
        self._controls = np.array([model.actuator(name).id for name in wheels])
        self._places = model.jnt_qposadr[[model.joint(name).id for name in wheels]]

    def drive(self, robot: DrivenRobot, data: Any) -> None:
        """Come nearer to the commanded velocity, as fast as the robot can."""
        spec = self.spec
        forward, _, turn = robot.command
        forward = max(-spec.speed, min(spec.speed, forward))
        if self._now == (forward, turn):
            return
        most = spec.acceleration * STEP_S
        speed = _nearer(self._now[0], forward, most)
        turn = _nearer(self._now[1], turn, most / (spec.separation / 2))
        self._now = (speed, turn)
        wanted = (speed + self._sides * (turn * spec.separation / 2)) / spec.radius * self._signs
        data.ctrl[self._controls] = wanted

    def travelled(self, robot: DrivenRobot, data: Any) -> Way:  # noqa: ARG002 - the base class has it
        """Return the way of a robot whose wheels do not slip."""
        angles = data.qpos[self._places]
        before, self._angles = self._angles, angles
        if before is None:
            return (0.0, 0.0, 0.0)
        count = len(self.spec.left)
        ways = (angles - before) * self._signs * self.spec.radius
        left, right = float(ways[:count].mean()), float(ways[count:].mean())
        return ((left + right) / 2, 0.0, (right - left) / self.spec.separation)


class SlidingMotors(Motors):
    """Motors of wheels that also slide or roll sideways: four wheels, or wheels for all directions.

    The floor does not hold the wheels one by one. One force pulls the robot towards the velocity of
    its wheels. It is at most the robot's weight, so a wall stops the robot, and its wheels slip.
    """

    def __init__(self, drive: Drive, model: RobotModel) -> None:
        self.spec, self._root = drive, model.tree.root
        self._wheels = [*drive.left, *drive.right]
        self._rolls = np.array([_rolling(name, drive.radius, model) for name in self._wheels])
        self._now = np.zeros(3)  # the velocity of the wheels: forward, to the left, and the turn
        self._way = np.zeros(3)  # since the last measurement

    def reset(self) -> None:
        """Stand still."""
        self._now[:] = self._way[:] = 0

    def bind(self, model: Any, prefix: str) -> None:
        """Find the mass of the robot, and its moment of inertia about the vertical axis."""
        first = model.jnt_dofadr[model.body_jntadr[model.body(prefix + self._root).id]]
        self._mass, self._moment = float(model.dof_M0[first]), float(model.dof_M0[first + 5])
        names = [prefix + name for name in self._wheels]
        self._controls = np.array([model.actuator(name).id for name in names], np.int64)

    def drive(self, robot: DrivenRobot, data: Any) -> None:
        """Turn the wheels, and pull the robot towards their velocity."""
        spec, most = self.spec, self.spec.acceleration * STEP_S
        wanted = np.array(robot.command) * (1.0, spec.kind == "omni", 1.0)
        wanted[:2] = np.clip(wanted[:2], -spec.speed, spec.speed)
        fastest = np.array([most, most, most * _TURN_SHARE])
        self._now += np.clip(wanted - self._now, -fastest, fastest)
        self._way += self._now * STEP_S
        if self._wheels:
            data.ctrl[self._controls] = self._rolls @ self._now
        linear, angular = robot.velocity
        push = (self._now[:2] - linear[:2]) * (self._mass / _GRIP_S)
        size, strongest = float(np.hypot(*push)), self._mass * _GRAVITY_M_S2
        push *= min(1.0, strongest / size) if size else 1.0
        twist = (self._now[2] - angular[2]) * (self._moment / _GRIP_S)
        turned = to_matrix(robot.pose)
        data.xfrc_applied[robot.root, :3] = turned[:, :2] @ push
        data.xfrc_applied[robot.root, 3:] = turned[:, 2] * twist

    def travelled(self, robot: DrivenRobot, data: Any) -> Way:  # noqa: ARG002 - the base class has it
        """Return the way of a robot whose wheels do not slip."""
        forward, left, turn = self._way.tolist()
        self._way[:] = 0
        return (forward, left, turn)


class AckermannMotors(WheelMotors):
    """Motors of wheels that drive, and of front wheels that steer as those of a car."""

    def __init__(self, drive: Drive) -> None:
        super().__init__(drive)
        self._steer = 0.0

    def reset(self) -> None:
        """Stand still, with straight wheels."""
        super().reset()
        self._steer = 0.0

    def bind(self, model: Any, prefix: str) -> None:
        """Find the wheels and the joints that steer."""
        super().bind(model, prefix)
        names = [prefix + name for name in self.spec.steering]
        self._angles_control = np.array([model.actuator(name).id for name in names])

    def drive(self, robot: DrivenRobot, data: Any) -> None:
        """Turn the wheels at the speeds and the angles of one circle."""
        spec = self.spec
        forward, _, turn = robot.command
        forward = max(-spec.speed, min(spec.speed, forward))
        most = spec.acceleration * STEP_S
        speed = _nearer(self._now[0], forward, most)
        # The angle of a wheel in the middle, which rolls along the wanted circle.
        angle = turn if spec.steers_by_angle else math.atan2(turn * spec.wheel_base, abs(forward))
        angle = angle if spec.steers_by_angle or forward >= 0 else -angle
        angle = angle if spec.steers_by_angle or forward else 0.0
        angle = max(-spec.most_steering, min(spec.most_steering, angle))
        self._steer = _nearer(self._steer, angle, _STEERING_RATE * STEP_S)
        bend = math.tan(self._steer) / spec.wheel_base
        self._now = (speed, speed * bend)
        wanted = (speed + self._sides * (self._now[1] * spec.separation / 2)) / spec.radius
        data.ctrl[self._controls] = wanted * self._signs
        sides = np.array([-1.0, 1.0])[: len(self._angles_control)]
        data.ctrl[self._angles_control] = np.arctan2(
            bend * spec.wheel_base, 1 + sides * (bend * spec.separation / 2)
        )


def slides(model: RobotModel) -> bool:
    """Return whether the wheels of a robot slide or roll sideways when it drives."""
    drive = model.equipment.drive
    if drive is None or drive.kind == "ackermann":
        return False
    return drive.kind == "omni" or len(drive.left + drive.right) > 2


def motors_of(model: RobotModel) -> Motors:
    """Return the motors of a robot."""
    drive = model.equipment.drive
    if drive is None:
        return Motors()
    if drive.kind == "ackermann":
        return AckermannMotors(drive)
    return SlidingMotors(drive, model) if slides(model) else WheelMotors(drive)


def add_motors(spec: Any, prefix: str, model: RobotModel) -> None:
    """Add the motors of a robot's wheels to a world."""
    drive = model.equipment.drive
    if drive is None or not drive.left + drive.right:
        return
    wheels = (*drive.left, *drive.right)
    mass = sum(inertia.mass for inertia in model.inertia.values()) or 1.0
    share = 2 * mass / len(wheels)
    for name in drive.steering:
        add_servo(spec, prefix + name, share * _STEERING_ARM_M**2, model.tree.joints[name].effort)
    # A wheel can push with the weight on it: more would only let it slip.
    most = share * _GRAVITY_M_S2 * drive.radius
    for name in wheels:
        effort = model.tree.joints[name].effort
        # A motor with a gear is heavy to turn. Without this, the wheels would tremble.
        spec.joint(prefix + name).armature = _ROTOR_SHARE * share * drive.radius**2
        motor = spec.add_actuator(
            name=prefix + name, target=prefix + name, trntype=engine().mjtTrn.mjTRN_JOINT
        )
        motor.set_to_velocity(kv=_STIFFNESS_S * share * drive.radius**2)
        # Files often have a placeholder for the effort, e.g. 0.01 or 100.
        limit = min(effort, most) if effort > most / 20 else most
        motor.forcelimited, motor.forcerange = 1, (-limit, limit)


def add_servo(spec: Any, joint: str, inertia: float, effort: float) -> None:
    """Add a motor that holds a position.

    Args:
        spec: The world.
        joint: The joint. The motor has the same name.
        inertia: The moment of inertia that it moves, in kg m^2, or the mass in kg.
        effort: Its largest torque or force.
    """
    motor = spec.add_actuator(name=joint, target=joint, trntype=engine().mjtTrn.mjTRN_JOINT)
    stiffness = inertia * _SERVO_S**-2
    motor.set_to_position(kp=stiffness, kv=2 * inertia / _SERVO_S)
    spec.joint(joint).armature = inertia * _ROTOR_SHARE
    if math.isfinite(effort) and effort > stiffness * _LEAST_ANGLE:
        motor.forcelimited, motor.forcerange = 1, (-effort, effort)


def _rolling(name: str, radius: float, model: RobotModel) -> list[float]:
    """Return the speed of a wheel for a velocity of 1 forward, to the left, and in the turn."""
    joint = model.tree.joints[name]
    at = model.part_of(joint.parent).members[joint.parent] @ joint.origin
    x, y, _ = at.translation
    axis = rotate(at.rotation, joint.axis)
    ahead, aside = axis[1] / radius, -axis[0] / radius  # where the wheel rolls
    return [ahead, aside, aside * x - ahead * y]


def _nearer(value: float, target: float, most: float) -> float:
    return value + max(-most, min(most, target - value))
