"""Motors of single joints, which other programs command by positions, velocities or efforts."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from zbot.simulation.engine import engine

if TYPE_CHECKING:
    from zbot.simulation.robots.model import RobotModel

Kind = Literal["position", "velocity", "effort"]

#: Time in which a motor reaches its position or its velocity.
_TIME_S = 0.03
#: How hard a motor holds a velocity, so that wheels which also slide sideways turn as commanded.
_DAMPER = 8.0
_ROTOR_SHARE = 0.1
#: The same of wheels that also slide sideways. The floor acts most against the direction in which
#: little inertia moves: with light rotors, it would stop the wheels' turn, not their slide.
_SLIDING_ROTOR_SHARE = 3.0
#: Efforts below this share of what a joint needs are placeholders in a description.
_LEAST_SHARE = 0.05
_GRAVITY_M_S2 = 9.81


class JointMotors:
    """Motors of some joints of a robot. A joint without a command moves freely."""

    def __init__(self, model: RobotModel) -> None:
        self._model = model
        kinds: dict[str, set[str]] = {}
        for command in model.equipment.joint_commands:
            kinds.setdefault(command.joint, set()).add(command.kind)
        for joint in model.controlled:
            kinds.setdefault(joint.name, set()).update(joint.commands)
        moving = model.tree.joints
        self._kinds = {
            name: found for name, found in kinds.items() if name in moving and any(found)
        }
        self._now: dict[str, tuple[Kind, float]] = {}

    @property
    def joints(self) -> list[str]:
        """The joints that have a motor."""
        return list(self._kinds)

    def add_to(self, spec: Any, prefix: str) -> None:
        """Add the motors to a world."""
        for name in self._kinds:
            if spec.joint(prefix + name) is None:
                continue
            target = {"target": prefix + name, "trntype": engine().mjtTrn.mjTRN_JOINT}
            motor = spec.add_actuator(name=f"{prefix}{name}#control", **target)
            motor.biastype = engine().mjtBias.mjBIAS_AFFINE
            motor.gainprm[0] = 0.0

    def bind(self, model: Any, data: Any, prefix: str) -> None:
        """Find the motors' numbers in a new compiled world."""
        self._physics, self._data = model, data
        self._places: dict[str, tuple[int, int, float]] = {}
        root = model.body(prefix + self._model.tree.root).id
        mass = float(model.body_subtreemass[root])
        for name in self._kinds:
            motor = engine().mj_name2id(
                model, engine().mjtObj.mjOBJ_ACTUATOR, f"{prefix}{name}#control"
            )
            if motor < 0:
                continue
            joint = model.joint(prefix + name).id
            dof = int(model.jnt_dofadr[joint])
            inertia = self._inertia(joint, dof, mass)
            if "effort" not in self._kinds[name]:
                rotor = inertia * self._rotor_share(name)
                model.dof_armature[dof] = max(model.dof_armature[dof], rotor)
            self._places[name] = (motor, dof, inertia)
            self._set_limit(name, motor, inertia)
        for name, (kind, value) in self._now.items():
            self._apply(name, kind, value)

    def _rotor_share(self, name: str) -> float:
        wheels = self._model.wheels
        return _SLIDING_ROTOR_SHARE if name in wheels and len(wheels) > 2 else _ROTOR_SHARE

    def _inertia(self, joint: int, dof: int, mass: float) -> float:
        """Return the inertia that a motor may have to move, e.g. the robot on its wheels."""
        model = self._physics
        own = float(model.dof_M0[dof])
        if self._model.is_fixed or model.jnt_type[joint] == engine().mjtJoint.mjJNT_SLIDE:
            return own
        body = model.jnt_bodyid[joint]
        geoms = np.flatnonzero(model.geom_bodyid == body)
        radius = float(model.geom_rbound[geoms].max(initial=0.0))
        return own + 0.5 * mass * min(radius, 0.5) ** 2

    def _set_limit(self, name: str, motor: int, inertia: float) -> None:
        """Limit the effort, unless the value in the description is a placeholder."""
        effort = self._model.tree.joints[name].effort
        if math.isfinite(effort) and effort > inertia * _GRAVITY_M_S2 * _LEAST_SHARE:
            self._physics.actuator_forcelimited[motor] = 1
            self._physics.actuator_forcerange[motor] = (-effort, effort)

    def command(self, name: str, kind: Kind, value: float) -> None:
        """Let a joint hold a position or a velocity, or push with an effort, from now on."""
        if self._now.get(name) != (kind, value) and math.isfinite(value):
            before = self._now.get(name)
            self._now[name] = (kind, value)
            self._apply(name, kind, value, is_new=before is None or before[0] != kind)

    def _apply(self, name: str, kind: Kind, value: float, *, is_new: bool = True) -> None:
        if name not in self._places:
            return
        motor, _, inertia = self._places[name]
        self._data.ctrl[motor] = value
        if not is_new:
            return
        spring, damper = inertia / _TIME_S**2, 2 * inertia / _TIME_S
        stiff = _DAMPER * inertia / _TIME_S
        gain = {"position": spring, "velocity": stiff, "effort": 1.0}[kind]
        bias = {"position": (-spring, -damper), "velocity": (0.0, -stiff), "effort": (0.0, 0.0)}
        self._physics.actuator_gainprm[motor, 0] = gain
        self._physics.actuator_biasprm[motor, :3] = (0.0, *bias[kind])

    def release(self, name: str) -> None:
        """Let a joint move freely again."""
        if self._now.pop(name, None) is not None and name in self._places:
            motor, dof, _ = self._places[name]
            self._physics.actuator_gainprm[motor, 0] = 0.0
            self._physics.actuator_biasprm[motor, :3] = 0.0
            self._data.qfrc_applied[dof] = 0.0

    def reset(self) -> None:
        """Forget all commands."""
        for name in list(self._now):
            self.release(name)

    def drive(self) -> None:
        """Carry the weight of joints that hold a position or a velocity, for one step."""
        for name, (kind, _) in self._now.items():
            if kind != "effort" and name in self._places:
                _, dof, _ = self._places[name]
                self._data.qfrc_applied[dof] = self._data.qfrc_bias[dof]

    def effort(self, name: str) -> float:
        """Return the torque or the force of a motor."""
        if name not in self._places:
            return 0.0
        motor, dof, _ = self._places[name]
        return float(self._data.actuator_force[motor] + self._data.qfrc_applied[dof])
