"""Services of the standard `simulation_interfaces`."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from simulation_interfaces.msg import Result, SimulationState, SimulatorFeatures
from simulation_interfaces.srv import (
    DeleteEntity,
    GetEntities,
    GetEntityState,
    GetSimulationState,
    GetSimulatorFeatures,
    ResetSimulation,
    SetEntityState,
    SetSimulationState,
    SpawnEntity,
    StepSimulation,
)

from zbot.errors import ZbotError
from zbot.libraries.robot_description.file import read_description
from zbot.libraries.robot_description.mesh_address import path_of
from zbot.names import validate_namespace
from zbot.simulation.node.frames import WORLD_FRAME
from zbot.simulation.robots.catalog import find_robot, robot_names
from zbot.simulation.robots.model import read_robot
from zbot.tf2.rigid import Rigid, normalized, rotate

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from zbot.simulation.node.pace import Pace
    from zbot.simulation.robots.model import RobotModel
    from zbot.simulation.world import World

_FEATURES = (
    SimulatorFeatures.SPAWNING,
    SimulatorFeatures.DELETING,
    SimulatorFeatures.SPAWNING_RESOURCE_STRING,
    SimulatorFeatures.ENTITY_STATE_GETTING,
    SimulatorFeatures.ENTITY_STATE_SETTING,
    SimulatorFeatures.SIMULATION_RESET,
    SimulatorFeatures.SIMULATION_RESET_TIME,
    SimulatorFeatures.SIMULATION_RESET_STATE,
    SimulatorFeatures.SIMULATION_RESET_SPAWNED,
    SimulatorFeatures.SIMULATION_STATE_GETTING,
    SimulatorFeatures.SIMULATION_STATE_SETTING,
    SimulatorFeatures.SIMULATION_STATE_PAUSE,
    SimulatorFeatures.STEP_SIMULATION_SINGLE,
    SimulatorFeatures.STEP_SIMULATION_MULTIPLE,
)
_NAMES_OF_CLASSIC = frozenset({"spawn_entity", "delete_entity", "reset_simulation"})
_MOST_STEPS = 100_000
_FARTHEST_M = 10_000.0


class ServedSimulator(Protocol):
    """The part of the simulator that services use."""

    world: World
    pace: Pace
    is_paused: bool

    @property
    def stamp(self) -> Any:
        """The time in the world, as a message."""
        ...

    def create_service(
        self, srv_type: type[Any], srv_name: str, callback: Callable[[Any, Any], Any]
    ) -> object:
        """Create a service."""
        ...

    def add_robots(self, robots: Iterable[tuple[str, str, RobotModel, Rigid]]) -> None:
        """Add robots."""
        ...

    def remove_robot(self, name: str) -> None:
        """Remove a robot."""
        ...

    def reset(self, *, time_too: bool) -> None:
        """Put all bodies back to where they started."""
        ...

    def step(self) -> None:
        """Move the world for one step."""
        ...


class RefusedError(ZbotError):
    """A request cannot be fulfilled.

    Attributes:
        code: The value of `Result.result`, or that of the service's own constants.
    """

    def __init__(self, code: int, reason: str) -> None:
        self.code = code
        super().__init__(reason)


class SimulationServices:
    """Services of one simulator.

    Args:
        simulator: The node that serves.
        is_classic: Whether Gazebo Classic has other services with some of these names.
    """

    def __init__(self, simulator: ServedSimulator, *, is_classic: bool = False) -> None:
        self._simulator = simulator
        self._spawned: set[str] = set()
        for type_, name, handle in (
            (GetSimulatorFeatures, "get_simulator_features", self._features),
            (GetEntities, "get_entities", self._entities),
            (GetEntityState, "get_entity_state", self._entity_state),
            (SetEntityState, "set_entity_state", self._set_entity_state),
            (SpawnEntity, "spawn_entity", self._spawn),
            (DeleteEntity, "delete_entity", self._delete),
            (ResetSimulation, "reset_simulation", self._reset),
            (GetSimulationState, "get_simulation_state", self._state),
            (SetSimulationState, "set_simulation_state", self._set_state),
            (StepSimulation, "step_simulation", self._step),
        ):
            if not (is_classic and name in _NAMES_OF_CLASSIC):
                simulator.create_service(type_, name, _answering(handle))

    def _features(self, _request: Any, response: Any) -> None:
        response.features.features = [int(feature) for feature in _FEATURES]
        response.features.spawn_formats = ["urdf"]
        response.features.custom_info = f"robots: {', '.join(robot_names())}"

    def _entities(self, request: Any, response: Any) -> None:
        world = self._simulator.world
        names = [*world.robots, *world.things]
        pattern = request.filters.filter
        if pattern:
            try:
                names = [name for name in names if re.search(pattern, name)]
            except re.error as error:
                raise RefusedError(
                    Result.RESULT_OPERATION_FAILED, f"{pattern!r} is not a pattern: {error}"
                ) from error
        response.entities = names

    def _entity_state(self, request: Any, response: Any) -> None:
        entity = self._find(request.entity)
        state, pose = response.state, entity.pose
        state.header.stamp, state.header.frame_id = self._simulator.stamp, WORLD_FRAME
        place, turned = state.pose.position, state.pose.orientation
        place.x, place.y, place.z = pose.translation
        turned.x, turned.y, turned.z, turned.w = pose.rotation
        linear, angular = (
            rotate(pose.rotation, (values[0], values[1], values[2]))
            for values in (part.tolist() for part in entity.velocity)
        )
        for vector, values in ((state.twist.linear, linear), (state.twist.angular, angular)):
            vector.x, vector.y, vector.z = values

    def _set_entity_state(self, request: Any, _response: Any) -> None:
        entity, state = self._find(request.entity), request.state
        if request.set_pose:
            _check_frame(state.header.frame_id)
            entity.pose = _pose(state.pose, SetEntityState.Response.INVALID_POSE)
            if not request.set_twist:
                entity.stop()
        if request.set_twist:
            twist = state.twist
            entity.set_velocity(_numbers(twist.linear), _numbers(twist.angular))
        self._simulator.world.refresh()

    def _spawn(self, request: Any, response: Any) -> None:
        codes = SpawnEntity.Response
        model = _model(request.entity_resource)
        name = self._free_name(request.name or model.tree.name, request.allow_renaming)
        namespace = request.entity_namespace.strip("/")
        if namespace:
            try:
                validate_namespace(f"/{namespace}")
            except ZbotError as error:
                raise RefusedError(codes.NAMESPACE_INVALID, str(error)) from error
        _check_frame(request.initial_pose.header.frame_id)
        pose = _pose(request.initial_pose.pose, codes.INVALID_POSE)
        self._simulator.add_robots([(name, namespace, model, pose)])
        self._spawned.add(name)
        response.entity_name = name

    def _free_name(self, name: str, may_change: bool) -> str:
        codes, world = SpawnEntity.Response, self._simulator.world
        if not re.fullmatch(r"\w[\w.-]{0,99}", name):
            raise RefusedError(
                codes.NAME_INVALID, f"a name has letters, digits and _, not {name[:40]!r}"
            )
        if world.entity(name) is None:
            return name
        if not may_change:
            raise RefusedError(codes.NAME_NOT_UNIQUE, f"there is already an entity '{name}'")
        number = 2
        while world.entity(f"{name}_{number}") is not None:
            number += 1
        return f"{name}_{number}"

    def _delete(self, request: Any, _response: Any) -> None:
        self._find(request.entity)
        if request.entity not in self._simulator.world.robots:
            raise RefusedError(
                Result.RESULT_OPERATION_FAILED, f"'{request.entity}' is a part of the world"
            )
        self._simulator.remove_robot(request.entity)
        self._spawned.discard(request.entity)

    def _reset(self, request: Any, _response: Any) -> None:
        scope = request.scope or ResetSimulation.Request.SCOPE_ALL
        if scope & ResetSimulation.Request.SCOPE_SPAWNED:
            for name in self._spawned & self._simulator.world.robots.keys():
                self._simulator.remove_robot(name)
            self._spawned.clear()
        if scope & ResetSimulation.Request.SCOPE_STATE:
            time_too = bool(scope & ResetSimulation.Request.SCOPE_TIME)
            self._simulator.reset(time_too=time_too)
        elif scope & ResetSimulation.Request.SCOPE_TIME:
            raise RefusedError(
                Result.RESULT_FEATURE_UNSUPPORTED, "the time is reset only with the state"
            )

    def _state(self, _request: Any, response: Any) -> None:
        paused, playing = SimulationState.STATE_PAUSED, SimulationState.STATE_PLAYING
        response.state.state = paused if self._simulator.is_paused else playing

    def _set_state(self, request: Any, _response: Any) -> None:
        wanted, simulator = request.state.state, self._simulator
        is_paused = wanted in {SimulationState.STATE_PAUSED, SimulationState.STATE_STOPPED}
        if not is_paused and wanted != SimulationState.STATE_PLAYING:
            raise RefusedError(
                Result.RESULT_FEATURE_UNSUPPORTED, "the state must be stopped, playing or paused"
            )
        if wanted == SimulationState.STATE_STOPPED:
            simulator.reset(time_too=True)
        elif is_paused == simulator.is_paused:
            raise RefusedError(
                SetSimulationState.Response.ALREADY_IN_TARGET_STATE, "it is in this state already"
            )
        simulator.is_paused = is_paused
        simulator.pace.restart()

    def _step(self, request: Any, _response: Any) -> None:
        if not self._simulator.is_paused:
            raise RefusedError(Result.RESULT_OPERATION_FAILED, "the simulation is not paused")
        if not 0 < request.steps <= _MOST_STEPS:
            raise RefusedError(
                Result.RESULT_OPERATION_FAILED, f"the steps must be 1 to {_MOST_STEPS}"
            )
        for _ in range(request.steps):
            self._simulator.step()

    def _find(self, name: str) -> Any:
        entity = self._simulator.world.entity(name)
        if entity is None:
            raise RefusedError(Result.RESULT_NOT_FOUND, f"there is no entity '{name[:100]}'")
        return entity


def _answering(handle: Callable[[Any, Any], None]) -> Callable[[Any, Any], Any]:
    """Return the callback of a service whose errors become its result."""

    def answer(request: Any, response: Any) -> Any:
        has_result = hasattr(response, "result")
        try:
            handle(request, response)
        except ZbotError as error:
            failed = Result.RESULT_OPERATION_FAILED
            response.result.result = getattr(error, "code", failed)
            response.result.error_message = str(error)
        else:
            if has_result:
                response.result.result = Result.RESULT_OK
        return response

    return answer


def _model(resource: Any) -> RobotModel:
    codes = SpawnEntity.Response
    try:
        if resource.resource_string:
            return read_robot(resource.resource_string)
        if resource.uri in robot_names():
            return find_robot(resource.uri)
        if resource.uri:
            return read_robot(read_description(path_of(resource.uri)))
    except ZbotError as error:
        raise RefusedError(codes.RESOURCE_PARSE_ERROR, str(error)) from error
    raise RefusedError(codes.NO_RESOURCE, "uri and resource_string are empty")


def _check_frame(frame: str) -> None:
    if frame not in {"", WORLD_FRAME}:
        raise RefusedError(
            Result.RESULT_OPERATION_FAILED, f"the frame must be '{WORLD_FRAME}', not {frame[:40]!r}"
        )


def _pose(message: Any, code: int) -> Rigid:
    place, turned = message.position, message.orientation
    at, rotation = (place.x, place.y, place.z), (turned.x, turned.y, turned.z, turned.w)
    is_finite = all(map(math.isfinite, (*at, *rotation)))
    if not is_finite or max(map(abs, at)) > _FARTHEST_M or abs(math.hypot(*rotation) - 1) > 0.01:
        raise RefusedError(code, "the pose needs finite numbers and an orientation of length 1")
    return Rigid(at, normalized(rotation))


def _numbers(vector: Any) -> Any:
    values = np.array([vector.x, vector.y, vector.z])
    if not np.isfinite(values).all() or np.abs(values).max() > 1000:
        raise RefusedError(Result.RESULT_OPERATION_FAILED, "a velocity must be below 1000")
    return values
