"""World in which robots drive: its bodies, its robots and its time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.simulation.engine import engine
from zbot.simulation.errors import SimulationError
from zbot.simulation.free_body import FreeBody
from zbot.simulation.robots.equipment import EARTH
from zbot.simulation.robots.robot import Robot

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import NDArray

    from zbot.simulation.robots.model import RobotModel
    from zbot.tf2.rigid import Rigid

_MOST_ROBOTS = 200
_DEEP_M = 0.005


class World:
    """Bodies and robots that the physics moves. Only one thread may use it.

    Args:
        spec: The world without robots, as an `MjSpec`.
        seed: The seed of all noise. The same seed and the same commands give the same run.
        earth: Where the origin is on the Earth: latitude and longitude in degrees, and altitude in
            metres. None means the middle of Berlin.

    Raises:
        SimulationError: The world cannot be made.
    """

    def __init__(
        self, spec: Any, *, seed: int = 0, earth: tuple[float, float, float] | None = None
    ) -> None:
        self.spec, self.seed, self.earth = spec, seed, earth or EARTH
        self.robots: dict[str, Robot] = {}
        self.things: dict[str, FreeBody] = {}  #: what robots can push
        self.steps = 0  #: since the start or the last reset of the time
        self._made = 0
        self.model: Any = None
        self.data: Any = None
        self.compile()

    @property
    def step_s(self) -> float:
        """Seconds of one step."""
        return float(self.model.opt.timestep)

    @property
    def time_ns(self) -> int:
        """The time in the world, in nanoseconds."""
        return round(self.steps * self.step_s * 1e9)

    def add(
        self, robots: Iterable[tuple[str, RobotModel, Rigid]], *, on_floor: bool = True
    ) -> list[Robot]:
        """Add robots. Their names, models and poses are given.

        Args:
            robots: The robots.
            on_floor: Whether the height of a pose is that of the floor. Otherwise it is that of
                the root, and only a robot that would be inside of something stands on it.

        Raises:
            SimulationError: A robot cannot be made. Then none is added.
        """
        added: list[Robot] = []
        try:
            for name, model, pose in robots:
                added.append(self._new_robot(name, model, pose))
                added[-1].add_to(self.spec)
            self.compile()
            for robot in added:
                if robot.is_free and (on_floor or self._is_inside(robot)):
                    robot.stand_on(robot.start.translation[2])
            self.refresh()
        except Exception:
            for robot in added:
                robot.remove_from(self.spec)
                del self.robots[robot.name]
            if added:  # the physics may have them already
                self.compile()
            raise
        return added

    def _is_inside(self, robot: Robot) -> bool:
        """Return whether a robot is inside of something else."""
        contacts = self.data.contact
        deep = contacts.geom[contacts.dist < -_DEEP_M]
        return bool((np.isin(deep, robot.geoms).sum(axis=1) == 1).any())

    def _new_robot(self, name: str, model: RobotModel, pose: Rigid) -> Robot:
        if name in self.robots:
            raise SimulationError(f"there is already a robot '{name}'")
        if len(self.robots) >= _MOST_ROBOTS:
            raise SimulationError(f"the world has {_MOST_ROBOTS} robots, which is the limit")
        robot = self.robots[name] = Robot(name, model, pose, self._made)
        self._made += 1
        return robot

    def remove(self, name: str) -> None:
        """Remove a robot."""
        self.robots.pop(name).remove_from(self.spec)
        self.compile()

    def compile(self) -> None:
        """Make the physics from the bodies. What moves keeps its pose and its velocity.

        Raises:
            SimulationError: MuJoCo does not accept a body.
        """
        mujoco = engine()
        try:
            if self.model is None:
                self.model = self.spec.compile()
                self.data = mujoco.MjData(self.model)
            else:
                self.model, self.data = self.spec.recompile(self.model, self.data)
        except (ValueError, mujoco.FatalError) as error:
            reason = str(error).removeprefix("Error: ").splitlines()[0]
            raise SimulationError(f"the world cannot be made: {reason}") from error
        for robot in self.robots.values():
            robot.bind(self.model, self.data)
        self._find_things()
        self.refresh()

    def _find_things(self) -> None:
        model = self.model
        roots = {robot.root for robot in self.robots.values()}
        free = engine().mjtJoint.mjJNT_FREE
        self.things.clear()
        for body in model.jnt_bodyid[model.jnt_type == free].tolist():
            if body not in roots:
                name = model.body(body).name.partition("/")[0]
                thing = FreeBody(name or f"body{body}")
                thing.bind_root(model, self.data, body)
                self.things[thing.name] = thing

    def entity(self, name: str) -> FreeBody | None:
        """Return the robot or the thing of a name, or None if there is none."""
        return self.robots.get(name) or self.things.get(name)

    @property
    def broke_down(self) -> bool:
        """Whether values became too large since the last reset. All bodies then went back."""
        kinds = engine().mjtWarning
        bad = (kinds.mjWARN_BADQPOS, kinds.mjWARN_BADQVEL, kinds.mjWARN_BADQACC)
        return any(self.data.warning[int(kind)].number for kind in bad)

    def refresh(self) -> None:
        """Compute the poses of all bodies and their contacts, after a change of the state.

        Raises:
            SimulationError: There are too many contacts.
        """
        self._move(engine().mj_step1)

    def _move(self, *parts: Any) -> None:
        try:
            for part in parts:
                part(self.model, self.data)
        except engine().FatalError as error:
            raise SimulationError(
                "the physics has no memory for all contacts: use fewer bodies that touch each other"
            ) from error

    def step(self) -> None:
        """Move all bodies for one step.

        Raises:
            SimulationError: There are too many contacts.
        """
        mujoco = engine()
        for robot in self.robots.values():
            robot.drive()
        # In this order, all poses and contacts are those of the new time.
        self._move(mujoco.mj_step2, mujoco.mj_step1)
        self.steps += 1

    def reset(self) -> None:
        """Put all bodies back to where they started."""
        engine().mj_resetData(self.model, self.data)
        for robot in self.robots.values():
            robot.pose = robot.start
            robot.command = (0.0, 0.0, 0.0)
            robot.motors.reset()
            robot.joint_motors.reset()
        self.refresh()

    def bounds(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the lowest and the highest x and y of what never moves, except for the floor."""
        model = self.model
        fixed = (model.body_weldid[model.geom_bodyid] == 0) & (model.geom_type != 0)
        if not fixed.any():
            return np.full(2, -5.0), np.full(2, 5.0)
        places = self.data.geom_xpos[fixed, :2]
        turns = np.abs(self.data.geom_xmat[fixed].reshape(-1, 3, 3)[:, :2])
        reach = (turns * model.geom_aabb[fixed, None, 3:]).sum(axis=2)
        return (places - reach).min(axis=0), (places + reach).max(axis=0)

    def name_of(self, geom: int) -> str:
        """Return the name of the robot or the thing that a solid belongs to."""
        body = int(self.model.body_rootid[self.model.geom_bodyid[geom]])
        name = self.model.body(body).name if body else self.model.geom(geom).name
        return str(name).partition("/")[0] or "wall"

    def noise(self, robot: Robot, sensor: int) -> np.random.Generator:
        """Return the source of the noise of a sensor in this step.

        It depends only on the seed and the step, not on the measurements before.
        """
        return np.random.default_rng((self.seed, robot.number, sensor, self.steps))

    def cast(
        self, origin: NDArray[np.float64], rays: NDArray[np.float64], *, unseen: Robot | None = None
    ) -> tuple[NDArray[np.float64], NDArray[np.int32], NDArray[np.float64]]:
        """Return how far rays from a point go, what they hit, and the normals of the surfaces.

        Args:
            origin: The point, in the world.
            rays: The directions with the length 1, in the world, one in a row.
            unseen: A robot that the rays go through.

        Returns:
            Distances in metres, or -1 without a hit; the numbers of what was hit, or -1; normals.
        """
        count = len(rays)
        distances, hits = np.empty(count), np.empty(count, np.int32)
        normals = np.empty((count, 3))
        groups = self.model.geom_group
        hidden = np.empty(0, np.int64) if unseen is None else unseen.geoms
        kept = groups[hidden].copy()
        groups[hidden] = _HIDDEN_GROUP
        engine().mj_multiRay(
            self.model,
            self.data,
            origin,
            np.ascontiguousarray(rays).ravel(),
            _SEEN_GROUPS,
            1,
            -1,
            hits,
            distances,
            normals.reshape(-1),
            count,
            _FARTHEST_M,
        )
        groups[hidden] = kept
        return distances, hits, normals


_HIDDEN_GROUP = 5
_SEEN_GROUPS = np.array([1, 1, 1, 1, 1, 0], np.uint8)
_FARTHEST_M = 1000.0
