"""Bodies of a robot in a world, made from its model."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple, cast

import numpy as np

from zbot.simulation.engine import engine
from zbot.simulation.errors import SimulationError
from zbot.simulation.meshes.hull import add_mesh
from zbot.simulation.robots.motors import slides
from zbot.simulation.rotation import to_matrix

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from zbot.libraries.robot_description.appearance import Solid
    from zbot.simulation.robots.model import Part, RobotModel
    from zbot.tf2.rigid import Rigid

    Matrix = NDArray[np.float64]

_LEAST_MASS_KG, _LEAST_MOMENT = 1e-6, 1e-12
_BALL_M2 = 1e-4
_USUAL_FRICTION = 0.6
_WHEEL_FRICTION = 1.0
#: Larger values make the physics break down.
_MOST = 1e6
_FARTHEST_M = 10_000.0


def add_bodies(
    spec: Any, prefix: str, model: RobotModel, pose: Rigid, number: int | None
) -> list[str]:
    """Add the bodies and joints of a robot to a world. Return what was left out.

    Args:
        spec: The world.
        prefix: Text before the names of all bodies and joints.
        model: The robot.
        pose: Where its root starts.
        number: The robot's number in the world. The parts of one robot do not collide. None means
            a thing, whose parts collide.

    Raises:
        SimulationError: A mass, a moment or a file of the robot cannot be used.
    """
    bodies: dict[str, Any] = {}
    notices: list[str] = []
    for part in model.parts:
        joint = part.joint
        if joint is None:
            body = spec.worldbody.add_body(name=prefix + part.link, **placed(pose))
            if not model.is_fixed:
                body.add_freejoint()
        else:
            owner = model.part_of(joint.parent)
            inside = owner.members[joint.parent] @ joint.origin
            body = bodies[owner.link].add_body(name=prefix + part.link, **placed(inside))
            _add_joint(body, prefix, part, in_degrees=bool(spec.compiler.degree))
        bodies[part.link] = body
        if joint is not None or not model.is_fixed:
            _set_inertia(body, part, model)
        notices += _add_solids(spec, body, part, model, _Owner(prefix, number))
    _add_mimics(spec, prefix, model)
    return notices


def _add_mimics(spec: Any, prefix: str, model: RobotModel) -> None:
    """Let joints follow the joints that they mimic."""
    for joint in model.tree.joints.values():
        mimic = joint.mimic
        if mimic is None or spec.joint(prefix + mimic.joint) is None:
            continue
        rule = spec.add_equality(
            name=f"{prefix}{joint.name}#mimic",
            type=engine().mjtEq.mjEQ_JOINT,
            objtype=engine().mjtObj.mjOBJ_JOINT,
            name1=prefix + joint.name,
            name2=prefix + mimic.joint,
        )
        rule.data[:5] = (mimic.offset, mimic.multiplier, 0.0, 0.0, 0.0)


class _Owner(NamedTuple):
    """Robot to which solids belong."""

    prefix: str
    number: int | None

    @property
    def bits(self) -> dict[str, int]:
        """The bits of its solids. MuJoCo has 32: two robots with the same bit do not collide."""
        if self.number is None:
            return {"contype": 1, "conaffinity": 0x7FFFFFFF}
        bit = 1 << (1 + self.number % 30)
        return {"contype": bit, "conaffinity": ~bit & 0x7FFFFFFF}


def placed(pose: Rigid) -> dict[str, Any]:
    """Return a pose as the arguments of MuJoCo's bodies and solids.

    Raises:
        SimulationError: It is very far away.
    """
    if not all(abs(part) <= _FARTHEST_M for part in pose.translation):
        raise SimulationError("a part is more than 10 km away")
    x, y, z, w = pose.rotation
    return {"pos": pose.translation, "quat": (w, x, y, z)}


def _add_joint(body: Any, prefix: str, part: Part, *, in_degrees: bool) -> None:
    joint, kinds = part.joint, engine().mjtJoint
    if joint is None or not any(joint.axis):
        return
    is_limited = joint.type != "continuous" and joint.lower < joint.upper
    is_straight = joint.type == "prismatic"
    unit = math.degrees(1) if in_degrees and not is_straight else 1.0  # MuJoCo's usual unit
    body.add_joint(
        name=prefix + joint.name,
        type=kinds.mjJNT_SLIDE if is_straight else kinds.mjJNT_HINGE,
        axis=joint.axis,
        limited=int(is_limited),
        range=(joint.lower * unit, joint.upper * unit) if is_limited else (0, 0),
        damping=min(max(joint.damping, 0.0), _MOST),
        frictionloss=min(max(joint.friction, 0.0), _MOST),
    )


def _set_inertia(body: Any, part: Part, model: RobotModel) -> None:
    """Give a body the masses of all its links."""
    known = [
        (model.inertia[link], pose @ model.inertia[link].origin)
        for link, pose in part.members.items()
        if link in model.inertia
    ]
    mass = sum(inertia.mass for inertia, _ in known)
    if not known and any(model.solids.get(link) for link in part.members):
        return  # MuJoCo computes the mass from the solids, with the density of water
    if mass < _LEAST_MASS_KG or mass > _MOST:
        raise SimulationError(
            f"the link '{part.link}' moves, but its mass is {mass:g} kg: give it an <inertial> "
            f"with {_LEAST_MASS_KG:g} to {_MOST:g} kg"
        )
    centers = [inertia.mass * np.array(at.translation) for inertia, at in known]
    middle: Matrix = np.sum(centers, axis=0) / mass
    moments: Matrix = np.sum(
        [_moments(inertia.moments, inertia.mass, at, middle) for inertia, at in known], axis=0
    )
    values = np.linalg.eigvalsh(moments)
    if model.is_gazebo and values[0] < _LEAST_MOMENT:
        # Gazebo's engine accepts this. MuJoCo needs a moment: that of a small ball.
        moments = moments + np.eye(3) * mass * _BALL_M2
        values = np.linalg.eigvalsh(moments)
    if values[0] < _LEAST_MOMENT or values[2] > _MOST:
        raise SimulationError(
            f"the link '{part.link}' moves, but its moments of inertia are {values[0]:g} to "
            f"{values[2]:g} kg m^2: give <inertia> values above 0, at most {_MOST:g}"
        )
    body.mass, body.ipos, body.explicitinertial = mass, middle, 1
    xx, yy, zz, xy, xz, yz = (
        moments[pair] for pair in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
    )
    body.fullinertia = (xx, yy, zz, xy, xz, yz)


def _moments(values: tuple[float, ...], mass: float, at: Rigid, middle: Matrix) -> Matrix:
    """Return the moments of a link about the middle of its body."""
    xx, yy, zz, xy, xz, yz = values
    turn = to_matrix(at)
    own = turn @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ turn.T
    away = np.array(at.translation) - middle
    moved = own + mass * (float(away @ away) * np.eye(3) - np.outer(away, away))
    return cast("Matrix", moved)


def _add_solids(spec: Any, body: Any, part: Part, model: RobotModel, owner: _Owner) -> list[str]:
    is_wheel = part.joint is not None and part.joint.name in model.wheels
    glides = slides(model)
    notices = []
    for link, pose in part.members.items():
        usual = _WHEEL_FRICTION if is_wheel else _USUAL_FRICTION
        # Values of 100 and more are common in files, but no rubber has them.
        friction = min(max(model.equipment.friction.get(link, usual), 0.0), 2.0)
        friction = 0.0 if glides else friction
        for place, solid in enumerate(model.solids.get(link, ())):
            shape = shape_of(spec, solid, is_wheel=is_wheel)
            if isinstance(shape, str):
                notices.append(shape)
                continue
            body.add_geom(
                **shape,
                friction=(max(friction, 1e-4), 0.005, 0.0001),
                priority=int(glides or link in model.equipment.friction),
                name=f"{owner.prefix}{link}#{place}",
                **owner.bits,
                **placed(pose @ solid.origin),
            )
    return notices


def shape_of(spec: Any, solid: Solid, *, is_wheel: bool = False) -> dict[str, Any] | str:
    """Return the shape of a solid, or why it is left out."""
    kinds = engine().mjtGeom
    x, y, z = (abs(part) / 2 for part in solid.size)
    if solid.kind == "mesh":
        return add_mesh(spec, solid)
    if not 0 < min(x, y, z) <= max(x, y, z) < _MOST:
        return f"a <{solid.kind}> of the size {solid.size}"
    if solid.kind == "box":
        return {"type": kinds.mjGEOM_BOX, "size": (x, y, z)}
    if solid.kind == "sphere":
        return {"type": kinds.mjGEOM_SPHERE, "size": (x, 0, 0)}
    if is_wheel:
        # A tyre is round: it touches the floor in its middle, not along its whole width.
        return {"type": kinds.mjGEOM_ELLIPSOID, "size": (x, x, z)}
    return {"type": kinds.mjGEOM_CYLINDER, "size": (x, z, 0)}
