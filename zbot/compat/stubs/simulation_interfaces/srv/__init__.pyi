# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geometry_msgs.msg
import service_msgs.msg
import simulation_interfaces.msg
import simulation_interfaces.srv
from zbot.interfaces import Action, Message, Service

class DeleteEntity_Request(Message):
    """simulation_interfaces/srv/DeleteEntity_Request

    string entity
    """
    def __init__(self, *, entity: str = ..., check_fields: bool = ...) -> None: ...
    entity: str

class DeleteEntity_Response(Message):
    """simulation_interfaces/srv/DeleteEntity_Response

    Result result
    """
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result

class DeleteEntity_Event(Message):
    """simulation_interfaces/srv/DeleteEntity_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.DeleteEntity_Request] = ..., response: Collection[simulation_interfaces.srv.DeleteEntity_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.DeleteEntity_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.DeleteEntity_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.DeleteEntity_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.DeleteEntity_Response]) -> None: ...

class DeleteEntity(Service):
    Request: TypeAlias = DeleteEntity_Request
    Response: TypeAlias = DeleteEntity_Response
    Event: TypeAlias = DeleteEntity_Event

class GetAvailableWorlds_Request(Message):
    """simulation_interfaces/srv/GetAvailableWorlds_Request

    string[] additional_sources
    TagsFilter filter
    bool offline_only
    bool continue_on_error
    """
    def __init__(self, *, additional_sources: Collection[str] = ..., filter: simulation_interfaces.msg.TagsFilter = ..., offline_only: bool = ..., continue_on_error: bool = ..., check_fields: bool = ...) -> None: ...
    @property
    def additional_sources(self) -> list[str]: ...
    @additional_sources.setter
    def additional_sources(self, value: Collection[str]) -> None: ...
    filter: simulation_interfaces.msg.TagsFilter
    offline_only: bool
    continue_on_error: bool

class GetAvailableWorlds_Response(Message):
    """simulation_interfaces/srv/GetAvailableWorlds_Response

    uint8 DEFAULT_SOURCES_FAILED=101
    Result result
    WorldResource[] worlds
    """
    DEFAULT_SOURCES_FAILED: Final = 101
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., worlds: Collection[simulation_interfaces.msg.WorldResource] = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result
    @property
    def worlds(self) -> list[simulation_interfaces.msg.WorldResource]: ...
    @worlds.setter
    def worlds(self, value: Collection[simulation_interfaces.msg.WorldResource]) -> None: ...

class GetAvailableWorlds_Event(Message):
    """simulation_interfaces/srv/GetAvailableWorlds_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.GetAvailableWorlds_Request] = ..., response: Collection[simulation_interfaces.srv.GetAvailableWorlds_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.GetAvailableWorlds_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.GetAvailableWorlds_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.GetAvailableWorlds_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.GetAvailableWorlds_Response]) -> None: ...

class GetAvailableWorlds(Service):
    Request: TypeAlias = GetAvailableWorlds_Request
    Response: TypeAlias = GetAvailableWorlds_Response
    Event: TypeAlias = GetAvailableWorlds_Event

class GetCurrentWorld_Request(Message):
    """simulation_interfaces/srv/GetCurrentWorld_Request"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GetCurrentWorld_Response(Message):
    """simulation_interfaces/srv/GetCurrentWorld_Response

    uint8 NO_WORLD_LOADED=101
    Result result
    WorldResource world
    """
    NO_WORLD_LOADED: Final = 101
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., world: simulation_interfaces.msg.WorldResource = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result
    world: simulation_interfaces.msg.WorldResource

class GetCurrentWorld_Event(Message):
    """simulation_interfaces/srv/GetCurrentWorld_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.GetCurrentWorld_Request] = ..., response: Collection[simulation_interfaces.srv.GetCurrentWorld_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.GetCurrentWorld_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.GetCurrentWorld_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.GetCurrentWorld_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.GetCurrentWorld_Response]) -> None: ...

class GetCurrentWorld(Service):
    Request: TypeAlias = GetCurrentWorld_Request
    Response: TypeAlias = GetCurrentWorld_Response
    Event: TypeAlias = GetCurrentWorld_Event

class GetEntities_Request(Message):
    """simulation_interfaces/srv/GetEntities_Request

    EntityFilters filters
    """
    def __init__(self, *, filters: simulation_interfaces.msg.EntityFilters = ..., check_fields: bool = ...) -> None: ...
    filters: simulation_interfaces.msg.EntityFilters

class GetEntities_Response(Message):
    """simulation_interfaces/srv/GetEntities_Response

    Result result
    string[] entities
    """
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., entities: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result
    @property
    def entities(self) -> list[str]: ...
    @entities.setter
    def entities(self, value: Collection[str]) -> None: ...

class GetEntities_Event(Message):
    """simulation_interfaces/srv/GetEntities_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.GetEntities_Request] = ..., response: Collection[simulation_interfaces.srv.GetEntities_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.GetEntities_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.GetEntities_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.GetEntities_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.GetEntities_Response]) -> None: ...

class GetEntities(Service):
    Request: TypeAlias = GetEntities_Request
    Response: TypeAlias = GetEntities_Response
    Event: TypeAlias = GetEntities_Event

class GetEntitiesStates_Request(Message):
    """simulation_interfaces/srv/GetEntitiesStates_Request

    EntityFilters filters
    """
    def __init__(self, *, filters: simulation_interfaces.msg.EntityFilters = ..., check_fields: bool = ...) -> None: ...
    filters: simulation_interfaces.msg.EntityFilters

class GetEntitiesStates_Response(Message):
    """simulation_interfaces/srv/GetEntitiesStates_Response

    Result result
    string[] entities
    EntityState[] states
    """
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., entities: Collection[str] = ..., states: Collection[simulation_interfaces.msg.EntityState] = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result
    @property
    def entities(self) -> list[str]: ...
    @entities.setter
    def entities(self, value: Collection[str]) -> None: ...
    @property
    def states(self) -> list[simulation_interfaces.msg.EntityState]: ...
    @states.setter
    def states(self, value: Collection[simulation_interfaces.msg.EntityState]) -> None: ...

class GetEntitiesStates_Event(Message):
    """simulation_interfaces/srv/GetEntitiesStates_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.GetEntitiesStates_Request] = ..., response: Collection[simulation_interfaces.srv.GetEntitiesStates_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.GetEntitiesStates_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.GetEntitiesStates_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.GetEntitiesStates_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.GetEntitiesStates_Response]) -> None: ...

class GetEntitiesStates(Service):
    Request: TypeAlias = GetEntitiesStates_Request
    Response: TypeAlias = GetEntitiesStates_Response
    Event: TypeAlias = GetEntitiesStates_Event

class GetEntityBounds_Request(Message):
    """simulation_interfaces/srv/GetEntityBounds_Request

    string entity
    """
    def __init__(self, *, entity: str = ..., check_fields: bool = ...) -> None: ...
    entity: str

class GetEntityBounds_Response(Message):
    """simulation_interfaces/srv/GetEntityBounds_Response

    Result result
    Bounds bounds
    """
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., bounds: simulation_interfaces.msg.Bounds = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result
    bounds: simulation_interfaces.msg.Bounds

class GetEntityBounds_Event(Message):
    """simulation_interfaces/srv/GetEntityBounds_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.GetEntityBounds_Request] = ..., response: Collection[simulation_interfaces.srv.GetEntityBounds_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.GetEntityBounds_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.GetEntityBounds_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.GetEntityBounds_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.GetEntityBounds_Response]) -> None: ...

class GetEntityBounds(Service):
    Request: TypeAlias = GetEntityBounds_Request
    Response: TypeAlias = GetEntityBounds_Response
    Event: TypeAlias = GetEntityBounds_Event

class GetEntityInfo_Request(Message):
    """simulation_interfaces/srv/GetEntityInfo_Request

    string entity
    """
    def __init__(self, *, entity: str = ..., check_fields: bool = ...) -> None: ...
    entity: str

class GetEntityInfo_Response(Message):
    """simulation_interfaces/srv/GetEntityInfo_Response

    Result result
    EntityInfo info
    """
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., info: simulation_interfaces.msg.EntityInfo = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result
    info: simulation_interfaces.msg.EntityInfo

class GetEntityInfo_Event(Message):
    """simulation_interfaces/srv/GetEntityInfo_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.GetEntityInfo_Request] = ..., response: Collection[simulation_interfaces.srv.GetEntityInfo_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.GetEntityInfo_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.GetEntityInfo_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.GetEntityInfo_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.GetEntityInfo_Response]) -> None: ...

class GetEntityInfo(Service):
    Request: TypeAlias = GetEntityInfo_Request
    Response: TypeAlias = GetEntityInfo_Response
    Event: TypeAlias = GetEntityInfo_Event

class GetEntityState_Request(Message):
    """simulation_interfaces/srv/GetEntityState_Request

    string entity
    """
    def __init__(self, *, entity: str = ..., check_fields: bool = ...) -> None: ...
    entity: str

class GetEntityState_Response(Message):
    """simulation_interfaces/srv/GetEntityState_Response

    Result result
    EntityState state
    """
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., state: simulation_interfaces.msg.EntityState = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result
    state: simulation_interfaces.msg.EntityState

class GetEntityState_Event(Message):
    """simulation_interfaces/srv/GetEntityState_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.GetEntityState_Request] = ..., response: Collection[simulation_interfaces.srv.GetEntityState_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.GetEntityState_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.GetEntityState_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.GetEntityState_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.GetEntityState_Response]) -> None: ...

class GetEntityState(Service):
    Request: TypeAlias = GetEntityState_Request
    Response: TypeAlias = GetEntityState_Response
    Event: TypeAlias = GetEntityState_Event

class GetNamedPoseBounds_Request(Message):
    """simulation_interfaces/srv/GetNamedPoseBounds_Request

    string name
    """
    def __init__(self, *, name: str = ..., check_fields: bool = ...) -> None: ...
    name: str

class GetNamedPoseBounds_Response(Message):
    """simulation_interfaces/srv/GetNamedPoseBounds_Response

    Result result
    Bounds bounds
    """
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., bounds: simulation_interfaces.msg.Bounds = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result
    bounds: simulation_interfaces.msg.Bounds

class GetNamedPoseBounds_Event(Message):
    """simulation_interfaces/srv/GetNamedPoseBounds_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.GetNamedPoseBounds_Request] = ..., response: Collection[simulation_interfaces.srv.GetNamedPoseBounds_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.GetNamedPoseBounds_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.GetNamedPoseBounds_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.GetNamedPoseBounds_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.GetNamedPoseBounds_Response]) -> None: ...

class GetNamedPoseBounds(Service):
    Request: TypeAlias = GetNamedPoseBounds_Request
    Response: TypeAlias = GetNamedPoseBounds_Response
    Event: TypeAlias = GetNamedPoseBounds_Event

class GetNamedPoses_Request(Message):
    """simulation_interfaces/srv/GetNamedPoses_Request

    TagsFilter tags
    """
    def __init__(self, *, tags: simulation_interfaces.msg.TagsFilter = ..., check_fields: bool = ...) -> None: ...
    tags: simulation_interfaces.msg.TagsFilter

class GetNamedPoses_Response(Message):
    """simulation_interfaces/srv/GetNamedPoses_Response

    Result result
    NamedPose[] poses
    """
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., poses: Collection[simulation_interfaces.msg.NamedPose] = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result
    @property
    def poses(self) -> list[simulation_interfaces.msg.NamedPose]: ...
    @poses.setter
    def poses(self, value: Collection[simulation_interfaces.msg.NamedPose]) -> None: ...

class GetNamedPoses_Event(Message):
    """simulation_interfaces/srv/GetNamedPoses_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.GetNamedPoses_Request] = ..., response: Collection[simulation_interfaces.srv.GetNamedPoses_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.GetNamedPoses_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.GetNamedPoses_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.GetNamedPoses_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.GetNamedPoses_Response]) -> None: ...

class GetNamedPoses(Service):
    Request: TypeAlias = GetNamedPoses_Request
    Response: TypeAlias = GetNamedPoses_Response
    Event: TypeAlias = GetNamedPoses_Event

class GetSimulationState_Request(Message):
    """simulation_interfaces/srv/GetSimulationState_Request"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GetSimulationState_Response(Message):
    """simulation_interfaces/srv/GetSimulationState_Response

    SimulationState state
    Result result
    """
    def __init__(self, *, state: simulation_interfaces.msg.SimulationState = ..., result: simulation_interfaces.msg.Result = ..., check_fields: bool = ...) -> None: ...
    state: simulation_interfaces.msg.SimulationState
    result: simulation_interfaces.msg.Result

class GetSimulationState_Event(Message):
    """simulation_interfaces/srv/GetSimulationState_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.GetSimulationState_Request] = ..., response: Collection[simulation_interfaces.srv.GetSimulationState_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.GetSimulationState_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.GetSimulationState_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.GetSimulationState_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.GetSimulationState_Response]) -> None: ...

class GetSimulationState(Service):
    Request: TypeAlias = GetSimulationState_Request
    Response: TypeAlias = GetSimulationState_Response
    Event: TypeAlias = GetSimulationState_Event

class GetSimulatorFeatures_Request(Message):
    """simulation_interfaces/srv/GetSimulatorFeatures_Request"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GetSimulatorFeatures_Response(Message):
    """simulation_interfaces/srv/GetSimulatorFeatures_Response

    SimulatorFeatures features
    """
    def __init__(self, *, features: simulation_interfaces.msg.SimulatorFeatures = ..., check_fields: bool = ...) -> None: ...
    features: simulation_interfaces.msg.SimulatorFeatures

class GetSimulatorFeatures_Event(Message):
    """simulation_interfaces/srv/GetSimulatorFeatures_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.GetSimulatorFeatures_Request] = ..., response: Collection[simulation_interfaces.srv.GetSimulatorFeatures_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.GetSimulatorFeatures_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.GetSimulatorFeatures_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.GetSimulatorFeatures_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.GetSimulatorFeatures_Response]) -> None: ...

class GetSimulatorFeatures(Service):
    Request: TypeAlias = GetSimulatorFeatures_Request
    Response: TypeAlias = GetSimulatorFeatures_Response
    Event: TypeAlias = GetSimulatorFeatures_Event

class GetSpawnables_Request(Message):
    """simulation_interfaces/srv/GetSpawnables_Request

    string[] sources
    """
    def __init__(self, *, sources: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def sources(self) -> list[str]: ...
    @sources.setter
    def sources(self, value: Collection[str]) -> None: ...

class GetSpawnables_Response(Message):
    """simulation_interfaces/srv/GetSpawnables_Response

    Result result
    Spawnable[] spawnables
    """
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., spawnables: Collection[simulation_interfaces.msg.Spawnable] = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result
    @property
    def spawnables(self) -> list[simulation_interfaces.msg.Spawnable]: ...
    @spawnables.setter
    def spawnables(self, value: Collection[simulation_interfaces.msg.Spawnable]) -> None: ...

class GetSpawnables_Event(Message):
    """simulation_interfaces/srv/GetSpawnables_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.GetSpawnables_Request] = ..., response: Collection[simulation_interfaces.srv.GetSpawnables_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.GetSpawnables_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.GetSpawnables_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.GetSpawnables_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.GetSpawnables_Response]) -> None: ...

class GetSpawnables(Service):
    Request: TypeAlias = GetSpawnables_Request
    Response: TypeAlias = GetSpawnables_Response
    Event: TypeAlias = GetSpawnables_Event

class LoadWorld_Request(Message):
    """simulation_interfaces/srv/LoadWorld_Request

    Resource world_resource
    bool fail_on_unsupported_element
    bool ignore_missing_or_unsupported_assets
    """
    def __init__(self, *, world_resource: simulation_interfaces.msg.Resource = ..., fail_on_unsupported_element: bool = ..., ignore_missing_or_unsupported_assets: bool = ..., check_fields: bool = ...) -> None: ...
    world_resource: simulation_interfaces.msg.Resource
    fail_on_unsupported_element: bool
    ignore_missing_or_unsupported_assets: bool

class LoadWorld_Response(Message):
    """simulation_interfaces/srv/LoadWorld_Response

    uint8 UNSUPPORTED_FORMAT=101
    uint8 NO_RESOURCE=102
    uint8 RESOURCE_PARSE_ERROR=103
    uint8 MISSING_ASSETS=104
    uint8 UNSUPPORTED_ASSETS=105
    uint8 UNSUPPORTED_ELEMENTS=106
    Result result
    WorldResource world
    """
    UNSUPPORTED_FORMAT: Final = 101
    NO_RESOURCE: Final = 102
    RESOURCE_PARSE_ERROR: Final = 103
    MISSING_ASSETS: Final = 104
    UNSUPPORTED_ASSETS: Final = 105
    UNSUPPORTED_ELEMENTS: Final = 106
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., world: simulation_interfaces.msg.WorldResource = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result
    world: simulation_interfaces.msg.WorldResource

class LoadWorld_Event(Message):
    """simulation_interfaces/srv/LoadWorld_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.LoadWorld_Request] = ..., response: Collection[simulation_interfaces.srv.LoadWorld_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.LoadWorld_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.LoadWorld_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.LoadWorld_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.LoadWorld_Response]) -> None: ...

class LoadWorld(Service):
    Request: TypeAlias = LoadWorld_Request
    Response: TypeAlias = LoadWorld_Response
    Event: TypeAlias = LoadWorld_Event

class ResetSimulation_Request(Message):
    """simulation_interfaces/srv/ResetSimulation_Request

    uint8 SCOPE_DEFAULT=0
    uint8 SCOPE_TIME=1
    uint8 SCOPE_STATE=2
    uint8 SCOPE_SPAWNED=4
    uint8 SCOPE_ALL=255
    uint8 scope
    """
    SCOPE_DEFAULT: Final = 0
    SCOPE_TIME: Final = 1
    SCOPE_STATE: Final = 2
    SCOPE_SPAWNED: Final = 4
    SCOPE_ALL: Final = 255
    def __init__(self, *, scope: int = ..., check_fields: bool = ...) -> None: ...
    scope: int

class ResetSimulation_Response(Message):
    """simulation_interfaces/srv/ResetSimulation_Response

    Result result
    """
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result

class ResetSimulation_Event(Message):
    """simulation_interfaces/srv/ResetSimulation_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.ResetSimulation_Request] = ..., response: Collection[simulation_interfaces.srv.ResetSimulation_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.ResetSimulation_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.ResetSimulation_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.ResetSimulation_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.ResetSimulation_Response]) -> None: ...

class ResetSimulation(Service):
    Request: TypeAlias = ResetSimulation_Request
    Response: TypeAlias = ResetSimulation_Response
    Event: TypeAlias = ResetSimulation_Event

class SetEntityInfo_Request(Message):
    """simulation_interfaces/srv/SetEntityInfo_Request

    string entity
    EntityInfo info
    """
    def __init__(self, *, entity: str = ..., info: simulation_interfaces.msg.EntityInfo = ..., check_fields: bool = ...) -> None: ...
    entity: str
    info: simulation_interfaces.msg.EntityInfo

class SetEntityInfo_Response(Message):
    """simulation_interfaces/srv/SetEntityInfo_Response

    Result result
    """
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result

class SetEntityInfo_Event(Message):
    """simulation_interfaces/srv/SetEntityInfo_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.SetEntityInfo_Request] = ..., response: Collection[simulation_interfaces.srv.SetEntityInfo_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.SetEntityInfo_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.SetEntityInfo_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.SetEntityInfo_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.SetEntityInfo_Response]) -> None: ...

class SetEntityInfo(Service):
    Request: TypeAlias = SetEntityInfo_Request
    Response: TypeAlias = SetEntityInfo_Response
    Event: TypeAlias = SetEntityInfo_Event

class SetEntityState_Request(Message):
    """simulation_interfaces/srv/SetEntityState_Request

    string entity
    EntityState state
    bool set_pose
    bool set_twist
    bool set_acceleration
    """
    def __init__(self, *, entity: str = ..., state: simulation_interfaces.msg.EntityState = ..., set_pose: bool = ..., set_twist: bool = ..., set_acceleration: bool = ..., check_fields: bool = ...) -> None: ...
    entity: str
    state: simulation_interfaces.msg.EntityState
    set_pose: bool
    set_twist: bool
    set_acceleration: bool

class SetEntityState_Response(Message):
    """simulation_interfaces/srv/SetEntityState_Response

    uint8 INVALID_POSE=101
    Result result
    """
    INVALID_POSE: Final = 101
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result

class SetEntityState_Event(Message):
    """simulation_interfaces/srv/SetEntityState_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.SetEntityState_Request] = ..., response: Collection[simulation_interfaces.srv.SetEntityState_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.SetEntityState_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.SetEntityState_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.SetEntityState_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.SetEntityState_Response]) -> None: ...

class SetEntityState(Service):
    Request: TypeAlias = SetEntityState_Request
    Response: TypeAlias = SetEntityState_Response
    Event: TypeAlias = SetEntityState_Event

class SetSimulationState_Request(Message):
    """simulation_interfaces/srv/SetSimulationState_Request

    SimulationState state
    """
    def __init__(self, *, state: simulation_interfaces.msg.SimulationState = ..., check_fields: bool = ...) -> None: ...
    state: simulation_interfaces.msg.SimulationState

class SetSimulationState_Response(Message):
    """simulation_interfaces/srv/SetSimulationState_Response

    uint8 ALREADY_IN_TARGET_STATE=101
    uint8 STATE_TRANSITION_ERROR=102
    uint8 INCORRECT_TRANSITION=103
    Result result
    """
    ALREADY_IN_TARGET_STATE: Final = 101
    STATE_TRANSITION_ERROR: Final = 102
    INCORRECT_TRANSITION: Final = 103
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result

class SetSimulationState_Event(Message):
    """simulation_interfaces/srv/SetSimulationState_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.SetSimulationState_Request] = ..., response: Collection[simulation_interfaces.srv.SetSimulationState_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.SetSimulationState_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.SetSimulationState_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.SetSimulationState_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.SetSimulationState_Response]) -> None: ...

class SetSimulationState(Service):
    Request: TypeAlias = SetSimulationState_Request
    Response: TypeAlias = SetSimulationState_Response
    Event: TypeAlias = SetSimulationState_Event

class SpawnEntities_Request(Message):
    """simulation_interfaces/srv/SpawnEntities_Request

    SpawnEntity[] spawn_requests
    """
    def __init__(self, *, spawn_requests: Collection[simulation_interfaces.msg.SpawnEntity] = ..., check_fields: bool = ...) -> None: ...
    @property
    def spawn_requests(self) -> list[simulation_interfaces.msg.SpawnEntity]: ...
    @spawn_requests.setter
    def spawn_requests(self, value: Collection[simulation_interfaces.msg.SpawnEntity]) -> None: ...

class SpawnEntities_Response(Message):
    """simulation_interfaces/srv/SpawnEntities_Response

    uint8 ENTITIES_SPAWN_FAILED=150
    Result result
    SpawnResult[] results
    """
    ENTITIES_SPAWN_FAILED: Final = 150
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., results: Collection[simulation_interfaces.msg.SpawnResult] = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result
    @property
    def results(self) -> list[simulation_interfaces.msg.SpawnResult]: ...
    @results.setter
    def results(self, value: Collection[simulation_interfaces.msg.SpawnResult]) -> None: ...

class SpawnEntities_Event(Message):
    """simulation_interfaces/srv/SpawnEntities_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.SpawnEntities_Request] = ..., response: Collection[simulation_interfaces.srv.SpawnEntities_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.SpawnEntities_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.SpawnEntities_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.SpawnEntities_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.SpawnEntities_Response]) -> None: ...

class SpawnEntities(Service):
    Request: TypeAlias = SpawnEntities_Request
    Response: TypeAlias = SpawnEntities_Response
    Event: TypeAlias = SpawnEntities_Event

class SpawnEntity_Request(Message):
    """simulation_interfaces/srv/SpawnEntity_Request

    string name
    bool allow_renaming
    Resource entity_resource
    string entity_namespace
    geometry_msgs/PoseStamped initial_pose
    """
    def __init__(self, *, name: str = ..., allow_renaming: bool = ..., entity_resource: simulation_interfaces.msg.Resource = ..., entity_namespace: str = ..., initial_pose: geometry_msgs.msg.PoseStamped = ..., check_fields: bool = ...) -> None: ...
    name: str
    allow_renaming: bool
    entity_resource: simulation_interfaces.msg.Resource
    entity_namespace: str
    initial_pose: geometry_msgs.msg.PoseStamped

class SpawnEntity_Response(Message):
    """simulation_interfaces/srv/SpawnEntity_Response

    uint8 NAME_NOT_UNIQUE=101
    uint8 NAME_INVALID=102
    uint8 UNSUPPORTED_FORMAT=103
    uint8 NO_RESOURCE=104
    uint8 NAMESPACE_INVALID=105
    uint8 RESOURCE_PARSE_ERROR=106
    uint8 MISSING_ASSETS=107
    uint8 UNSUPPORTED_ASSETS=108
    uint8 INVALID_POSE=109
    Result result
    string entity_name
    """
    NAME_NOT_UNIQUE: Final = 101
    NAME_INVALID: Final = 102
    UNSUPPORTED_FORMAT: Final = 103
    NO_RESOURCE: Final = 104
    NAMESPACE_INVALID: Final = 105
    RESOURCE_PARSE_ERROR: Final = 106
    MISSING_ASSETS: Final = 107
    UNSUPPORTED_ASSETS: Final = 108
    INVALID_POSE: Final = 109
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., entity_name: str = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result
    entity_name: str

class SpawnEntity_Event(Message):
    """simulation_interfaces/srv/SpawnEntity_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.SpawnEntity_Request] = ..., response: Collection[simulation_interfaces.srv.SpawnEntity_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.SpawnEntity_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.SpawnEntity_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.SpawnEntity_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.SpawnEntity_Response]) -> None: ...

class SpawnEntity(Service):
    Request: TypeAlias = SpawnEntity_Request
    Response: TypeAlias = SpawnEntity_Response
    Event: TypeAlias = SpawnEntity_Event

class StepSimulation_Request(Message):
    """simulation_interfaces/srv/StepSimulation_Request

    uint64 steps 1
    """
    def __init__(self, *, steps: int = ..., check_fields: bool = ...) -> None: ...
    steps: int

class StepSimulation_Response(Message):
    """simulation_interfaces/srv/StepSimulation_Response

    Result result
    """
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result

class StepSimulation_Event(Message):
    """simulation_interfaces/srv/StepSimulation_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.StepSimulation_Request] = ..., response: Collection[simulation_interfaces.srv.StepSimulation_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.StepSimulation_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.StepSimulation_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.StepSimulation_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.StepSimulation_Response]) -> None: ...

class StepSimulation(Service):
    Request: TypeAlias = StepSimulation_Request
    Response: TypeAlias = StepSimulation_Response
    Event: TypeAlias = StepSimulation_Event

class UnloadWorld_Request(Message):
    """simulation_interfaces/srv/UnloadWorld_Request"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class UnloadWorld_Response(Message):
    """simulation_interfaces/srv/UnloadWorld_Response

    uint8 NO_WORLD_LOADED=101
    Result result
    """
    NO_WORLD_LOADED: Final = 101
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result

class UnloadWorld_Event(Message):
    """simulation_interfaces/srv/UnloadWorld_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.srv.UnloadWorld_Request] = ..., response: Collection[simulation_interfaces.srv.UnloadWorld_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.srv.UnloadWorld_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.srv.UnloadWorld_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.srv.UnloadWorld_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.srv.UnloadWorld_Response]) -> None: ...

class UnloadWorld(Service):
    Request: TypeAlias = UnloadWorld_Request
    Response: TypeAlias = UnloadWorld_Response
    Event: TypeAlias = UnloadWorld_Event
