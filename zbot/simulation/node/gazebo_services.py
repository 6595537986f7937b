"""Services of Gazebo, of both generations, beside those of the standard."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Protocol

from gazebo_msgs import srv as classic
from ros_gz_interfaces import srv as gz

from zbot.errors import ZbotError
from zbot.simulation.errors import SimulationError
from zbot.simulation.node.spawning import SpawningSimulator, Wanted, spawn
from zbot.tf2.rigid import Rigid, normalized

from std_srvs.srv import Empty

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.simulation.node.pace import Pace

_FARTHEST_M = 10_000.0


class GazeboSimulator(SpawningSimulator, Protocol):
    """The part of the simulator that these services use."""

    is_paused: bool
    pace: Pace

    def create_service(
        self, srv_type: type[Any], srv_name: str, callback: Callable[[Any, Any], Any]
    ) -> object:
        """Create a service."""
        ...

    def get_logger(self) -> Any:
        """Return the logger."""
        ...

    def remove_robot(self, name: str) -> None:
        """Remove a robot."""
        ...

    def reset(self, *, time_too: bool) -> None:
        """Put all bodies back to where they started."""
        ...


class GazeboServices:
    """Services that programs for Gazebo call.

    Args:
        simulator: The node that serves.
        is_classic: Whether the services are those of Gazebo Classic.
    """

    def __init__(self, simulator: GazeboSimulator, *, is_classic: bool) -> None:
        self._simulator = simulator
        start = f"/world/{simulator.world_name}"
        rows: tuple[tuple[type[Any], str, Callable[[Any, Any], Any]], ...] = (
            (gz.SpawnEntity, f"{start}/create", self._create),
            (gz.DeleteEntity, f"{start}/remove", self._remove),
            (gz.SetEntityPose, f"{start}/set_pose", self._set_pose),
            (gz.ControlWorld, f"{start}/control", self._control),
        )
        if is_classic:
            rows = (
                (classic.SpawnEntity, "/spawn_entity", self._spawn),
                (classic.DeleteEntity, "/delete_entity", self._delete),
                (classic.GetModelList, "/get_model_list", self._list),
                (Empty, "/reset_simulation", self._reset),
                (Empty, "/reset_world", self._reset),
                (Empty, "/pause_physics", self._pause),
                (Empty, "/unpause_physics", self._unpause),
            )
        for type_, name, handle in rows:
            simulator.create_service(type_, name, handle)

    # -- the new Gazebo ------------------------------------------------------------------------

    def _create(self, request: Any, response: Any) -> Any:
        wanted = request.entity_factory

        def act() -> None:
            pose = pose_of(wanted.pose)
            may_rename = wanted.allow_renaming
            row = Wanted(wanted.name, wanted.sdf, wanted.sdf_filename, pose, "", may_rename)
            spawn(self._simulator, row)

        response.success = self._attempt(act) is None
        return response

    def _remove(self, request: Any, response: Any) -> Any:
        response.success = self._attempt(lambda: self._take_away(request.entity.name)) is None
        return response

    def _set_pose(self, request: Any, response: Any) -> Any:
        response.success = self._attempt(lambda: self._move(request)) is None
        return response

    def _control(self, request: Any, response: Any) -> Any:
        wanted, simulator = request.world_control, self._simulator
        if wanted.reset.all or wanted.reset.time_only or wanted.reset.model_only:
            simulator.reset(time_too=not wanted.reset.model_only)
        simulator.is_paused = wanted.pause
        simulator.pace.restart()
        response.success = True
        return response

    # -- Gazebo Classic ------------------------------------------------------------------------

    def _spawn(self, request: Any, response: Any) -> Any:
        def act() -> None:
            pose = pose_of(request.initial_pose)
            row = Wanted(request.name, request.xml, "", pose, request.robot_namespace)
            spawn(self._simulator, row)

        error = self._attempt(act)
        response.success = error is None
        done = f"SpawnEntity: Successfully spawned entity [{request.name}]"
        response.status_message = error or done
        return response

    def _delete(self, request: Any, response: Any) -> Any:
        error = self._attempt(lambda: self._take_away(request.name))
        response.success = error is None
        response.status_message = error or f"DeleteEntity: deleted [{request.name}]"
        return response

    def _list(self, _request: Any, response: Any) -> Any:
        world = self._simulator.world
        response.model_names = [*world.robots, *world.things]
        response.success = True
        return response

    def _reset(self, _request: Any, response: Any) -> Any:
        self._simulator.reset(time_too=False)
        return response

    def _pause(self, _request: Any, response: Any) -> Any:
        self._simulator.is_paused = True
        return response

    def _unpause(self, _request: Any, response: Any) -> Any:
        self._simulator.is_paused = False
        self._simulator.pace.restart()
        return response

    # -- both ----------------------------------------------------------------------------------

    def _attempt(self, act: Callable[[], None]) -> str | None:
        """Call a function. Return its error, which also is logged."""
        try:
            act()
        except ZbotError as error:
            self._simulator.get_logger().error(str(error))
            return str(error)
        return None

    def _take_away(self, name: str) -> None:
        if name not in self._simulator.world.robots:
            raise SimulationError(f"there is no robot '{name[:100]}'")
        self._simulator.remove_robot(name)

    def _move(self, request: Any) -> None:
        entity = self._simulator.world.entity(request.entity.name)
        if entity is None:
            raise SimulationError(f"there is no entity '{request.entity.name[:100]}'")
        entity.pose = pose_of(request.pose)
        entity.stop()
        self._simulator.world.refresh()


def pose_of(message: Any) -> Rigid:
    """Return the pose in a message.

    Raises:
        SimulationError: A number is not finite or too large.
    """
    place, turned = message.position, message.orientation
    at, rotation = (place.x, place.y, place.z), (turned.x, turned.y, turned.z, turned.w)
    length = math.hypot(*rotation)
    if not all(map(math.isfinite, (*at, *rotation))) or max(map(abs, at)) > _FARTHEST_M:
        raise SimulationError("the pose needs finite numbers")
    return Rigid(at, normalized(rotation) if length > 0.01 else (0.0, 0.0, 0.0, 1.0))
