"""Equipment of a robot whose description has no `<gazebo>` tags, found by names and places."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

from zbot.libraries.robot_description.urdf import MOVING
from zbot.simulation.errors import SimulationError
from zbot.simulation.robots.equipment import Drive, Imu, Lidar, Sensor
from zbot.tf2.rigid import rotate

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from zbot.libraries.robot_description.appearance import Solid
    from zbot.libraries.robot_description.urdf import Joint, Robot
    from zbot.tf2.rigid import Rigid, Vector

    Solids = Mapping[str, Sequence[Solid]]

_LIDARS = ("scan", "laser", "lidar")
_ROUND = frozenset({"cylinder", "sphere"})


def find_drive(robot: Robot, poses: Mapping[str, Rigid], solids: Solids) -> Drive | None:
    """Return a drive from the joints with `wheel` in their names, or None if there are none."""
    wheels = _wheels(robot, poses)
    left = tuple(name for name in wheels if poses[robot.joints[name].child].translation[1] > 0)
    right = tuple(name for name in wheels if name not in left)
    if not left or not right:
        return None
    return complete(Drive("wheels", left, right, math.nan, math.nan), robot, poses, solids)


def complete(drive: Drive, robot: Robot, poses: Mapping[str, Rigid], solids: Solids) -> Drive:
    """Return a drive with the measures that its description leaves out.

    Raises:
        SimulationError: A joint does not exist, or the radius of the wheels is not known.
    """
    for name in (*drive.left, *drive.right, *drive.steering):
        if name not in robot.joints:
            raise SimulationError(f"the drive names the joint '{name}', which does not exist")
    if drive.kind == "omni":
        return _complete_omni(drive, robot, poses, solids)
    if not drive.left or not drive.right:
        raise SimulationError("the drive needs the names of a left and a right joint")
    if drive.kind == "ackermann":
        drive = _complete_ackermann(drive, robot, poses)
    left, right = robot.joints[drive.left[0]].child, robot.joints[drive.right[0]].child
    wheels = (*drive.left, *drive.right)
    # The axis of a wheel may point to the right: then the wheel turns backwards to drive forwards.
    signs = tuple(-1.0 if axis_of(robot.joints[name], poses)[1] < 0 else 1.0 for name in wheels)
    drive = replace(drive, signs=signs)
    if not drive.separation > 0:
        distance = poses[left].translation[1] - poses[right].translation[1]
        drive = replace(drive, separation=abs(distance))
    if not drive.radius > 0:
        drive = replace(drive, radius=_radius(left, solids))
    if not (0 < drive.separation < math.inf and 0 < drive.radius < math.inf):
        raise SimulationError("the wheels need a radius and a distance above 0")
    return drive


def _wheels(robot: Robot, poses: Mapping[str, Rigid]) -> list[str]:
    """Return the joints of wheels that drive."""
    return [
        joint.name
        for joint in robot.joints.values()
        if joint.type in MOVING
        and "wheel" in f"{joint.name} {joint.child}".lower()
        and "caster" not in f"{joint.name} {joint.child}".lower()
        and abs(axis_of(joint, poses)[2]) < 0.5  # the axis of a steering joint is vertical
    ]


def _complete_omni(drive: Drive, robot: Robot, poses: Mapping[str, Rigid], solids: Solids) -> Drive:
    """Return a drive with all wheels, which only turn as the robot moves."""
    wheels = tuple(drive.left + drive.right) or tuple(_wheels(robot, poses))
    radius = drive.radius
    if wheels and not radius > 0:
        radius = _radius(robot.joints[wheels[0]].child, solids)
    return replace(drive, left=wheels, right=(), radius=radius)


def _complete_ackermann(drive: Drive, robot: Robot, poses: Mapping[str, Rigid]) -> Drive:
    """Return a drive with the distance between the wheels that steer and the others."""
    if len(drive.steering) < 2:
        raise SimulationError("the drive needs the names of two joints that steer")
    if drive.wheel_base > 0:
        return drive
    front = poses[robot.joints[drive.steering[0]].child].translation[0]
    rear = min(poses[robot.joints[name].child].translation[0] for name in drive.left + drive.right)
    return replace(drive, wheel_base=abs(front - rear) or 1.0)


def find_sensors(robot: Robot) -> tuple[Sensor, ...]:
    """Return a lidar and an inertial sensor for links with usual names."""
    found: list[Sensor] = []
    for link in robot.links:
        name = link.lower()
        if any(word in name for word in _LIDARS) and not any(isinstance(s, Lidar) for s in found):
            found.append(Lidar(link, "scan", 10.0, 0.01))
        elif "imu" in name and not any(isinstance(sensor, Imu) for sensor in found):
            found.append(Imu(link, "imu", 100.0, 0.02, turn_noise=0.002))
    return tuple(found)


def axis_of(joint: Joint, poses: Mapping[str, Rigid]) -> Vector:
    """Return the axis of a joint in the axes of the root."""
    return rotate(poses[joint.child].rotation, joint.axis)


def _radius(link: str, solids: Solids) -> float:
    for solid in solids.get(link, ()):
        if solid.kind in _ROUND:
            return solid.size[0] / 2
    raise SimulationError(
        f"the radius of the wheel '{link}' is not known: its <collision> must be a cylinder"
    )
