"""Body of a world: a robot's root, or a thing that robots can push."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.simulation.engine import engine
from zbot.simulation.rotation import to_matrix
from zbot.tf2.rigid import Rigid

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

_LOWEST_M = -100.0


class FreeBody:
    """Body with a free joint, or a body that never moves by itself.

    Args:
        name: Its name among the entities of the world.

    Attributes:
        root: Its number in the compiled world.
    """

    def __init__(self, name: str) -> None:
        self.name = name
        self.root = 0
        self.is_free = True
        self._model: Any = None
        self._data: Any = None

    def bind_root(self, model: Any, data: Any, root: int) -> None:
        """Find the numbers of the body in a new compiled world."""
        self._model, self._data, self.root = model, data, root
        joint = int(model.body_jntadr[root])
        free = engine().mjtJoint.mjJNT_FREE
        self.is_free = bool(joint >= 0 and model.jnt_type[joint] == free)
        if self.is_free:
            self._position = int(model.jnt_qposadr[joint])
            self._velocity = int(model.jnt_dofadr[joint])

    @property
    def pose(self) -> Rigid:
        """The pose in the world."""
        if not self.is_free:
            x, y, z = self._model.body_pos[self.root].tolist()
            qw, qx, qy, qz = self._model.body_quat[self.root].tolist()
            return Rigid((x, y, z), (qx, qy, qz, qw))
        x, y, z, qw, qx, qy, qz = self._data.qpos[self._position : self._position + 7].tolist()
        return Rigid((x, y, z), (qx, qy, qz, qw))

    @pose.setter
    def pose(self, pose: Rigid) -> None:
        x, y, z, w = pose.rotation
        if not self.is_free:
            self._model.body_pos[self.root] = pose.translation
            self._model.body_quat[self.root] = (w, x, y, z)
            return
        self._data.qpos[self._position : self._position + 7] = (*pose.translation, w, x, y, z)

    @property
    def velocity(self) -> tuple[Array, Array]:
        """The velocity in m/s, and the turn in rad/s, in the body's own axes."""
        if not self.is_free:
            return np.zeros(3), np.zeros(3)
        values = self._data.qvel[self._velocity : self._velocity + 6]
        return to_matrix(self.pose).T @ values[:3], values[3:].copy()

    def set_velocity(self, linear: Array, angular: Array) -> None:
        """Set the velocity in m/s and the turn in rad/s, both in the axes of the world."""
        if not self.is_free:
            return
        self._data.qvel[self._velocity : self._velocity + 3] = linear
        turn = to_matrix(self.pose).T @ angular
        self._data.qvel[self._velocity + 3 : self._velocity + 6] = turn

    def stop(self) -> None:
        """Let the body stand still."""
        self.set_velocity(np.zeros(3), np.zeros(3))

    @property
    def is_lost(self) -> bool:
        """Whether the body fell out of the world."""
        z = self.pose.translation[2]
        return not math.isfinite(z) or z < _LOWEST_M
