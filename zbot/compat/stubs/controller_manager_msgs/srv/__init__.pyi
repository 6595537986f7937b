# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import controller_manager_msgs.msg
import controller_manager_msgs.srv
import lifecycle_msgs.msg
import service_msgs.msg
from zbot.interfaces import Action, Message, Service

class CleanupController_Request(Message):
    """controller_manager_msgs/srv/CleanupController_Request

    # Takes back the configuration of a controller.

    string name
    """
    def __init__(self, *, name: str = ..., check_fields: bool = ...) -> None: ...
    name: str

class CleanupController_Response(Message):
    """controller_manager_msgs/srv/CleanupController_Response

    bool ok
    """
    def __init__(self, *, ok: bool = ..., check_fields: bool = ...) -> None: ...
    ok: bool

class CleanupController_Event(Message):
    """controller_manager_msgs/srv/CleanupController_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[controller_manager_msgs.srv.CleanupController_Request] = ..., response: Collection[controller_manager_msgs.srv.CleanupController_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[controller_manager_msgs.srv.CleanupController_Request]: ...
    @request.setter
    def request(self, value: Collection[controller_manager_msgs.srv.CleanupController_Request]) -> None: ...
    @property
    def response(self) -> list[controller_manager_msgs.srv.CleanupController_Response]: ...
    @response.setter
    def response(self, value: Collection[controller_manager_msgs.srv.CleanupController_Response]) -> None: ...

class CleanupController(Service):
    Request: TypeAlias = CleanupController_Request
    Response: TypeAlias = CleanupController_Response
    Event: TypeAlias = CleanupController_Event

class ConfigureController_Request(Message):
    """controller_manager_msgs/srv/ConfigureController_Request

    # Configures a controller that was loaded.

    string name
    """
    def __init__(self, *, name: str = ..., check_fields: bool = ...) -> None: ...
    name: str

class ConfigureController_Response(Message):
    """controller_manager_msgs/srv/ConfigureController_Response

    bool ok
    """
    def __init__(self, *, ok: bool = ..., check_fields: bool = ...) -> None: ...
    ok: bool

class ConfigureController_Event(Message):
    """controller_manager_msgs/srv/ConfigureController_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[controller_manager_msgs.srv.ConfigureController_Request] = ..., response: Collection[controller_manager_msgs.srv.ConfigureController_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[controller_manager_msgs.srv.ConfigureController_Request]: ...
    @request.setter
    def request(self, value: Collection[controller_manager_msgs.srv.ConfigureController_Request]) -> None: ...
    @property
    def response(self) -> list[controller_manager_msgs.srv.ConfigureController_Response]: ...
    @response.setter
    def response(self, value: Collection[controller_manager_msgs.srv.ConfigureController_Response]) -> None: ...

class ConfigureController(Service):
    Request: TypeAlias = ConfigureController_Request
    Response: TypeAlias = ConfigureController_Response
    Event: TypeAlias = ConfigureController_Event

class ListControllerTypes_Request(Message):
    """controller_manager_msgs/srv/ListControllerTypes_Request

    # Lists the controllers that can be loaded.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class ListControllerTypes_Response(Message):
    """controller_manager_msgs/srv/ListControllerTypes_Response

    string[] types
    string[] base_classes  # one for each type
    """
    def __init__(self, *, types: Collection[str] = ..., base_classes: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def types(self) -> list[str]: ...
    @types.setter
    def types(self, value: Collection[str]) -> None: ...
    @property
    def base_classes(self) -> list[str]: ...
    @base_classes.setter
    def base_classes(self, value: Collection[str]) -> None: ...

class ListControllerTypes_Event(Message):
    """controller_manager_msgs/srv/ListControllerTypes_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[controller_manager_msgs.srv.ListControllerTypes_Request] = ..., response: Collection[controller_manager_msgs.srv.ListControllerTypes_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[controller_manager_msgs.srv.ListControllerTypes_Request]: ...
    @request.setter
    def request(self, value: Collection[controller_manager_msgs.srv.ListControllerTypes_Request]) -> None: ...
    @property
    def response(self) -> list[controller_manager_msgs.srv.ListControllerTypes_Response]: ...
    @response.setter
    def response(self, value: Collection[controller_manager_msgs.srv.ListControllerTypes_Response]) -> None: ...

class ListControllerTypes(Service):
    Request: TypeAlias = ListControllerTypes_Request
    Response: TypeAlias = ListControllerTypes_Response
    Event: TypeAlias = ListControllerTypes_Event

class ListControllers_Request(Message):
    """controller_manager_msgs/srv/ListControllers_Request

    # Lists the controllers that were loaded.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class ListControllers_Response(Message):
    """controller_manager_msgs/srv/ListControllers_Response

    controller_manager_msgs/ControllerState[] controller
    """
    def __init__(self, *, controller: Collection[controller_manager_msgs.msg.ControllerState] = ..., check_fields: bool = ...) -> None: ...
    @property
    def controller(self) -> list[controller_manager_msgs.msg.ControllerState]: ...
    @controller.setter
    def controller(self, value: Collection[controller_manager_msgs.msg.ControllerState]) -> None: ...

class ListControllers_Event(Message):
    """controller_manager_msgs/srv/ListControllers_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[controller_manager_msgs.srv.ListControllers_Request] = ..., response: Collection[controller_manager_msgs.srv.ListControllers_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[controller_manager_msgs.srv.ListControllers_Request]: ...
    @request.setter
    def request(self, value: Collection[controller_manager_msgs.srv.ListControllers_Request]) -> None: ...
    @property
    def response(self) -> list[controller_manager_msgs.srv.ListControllers_Response]: ...
    @response.setter
    def response(self, value: Collection[controller_manager_msgs.srv.ListControllers_Response]) -> None: ...

class ListControllers(Service):
    Request: TypeAlias = ListControllers_Request
    Response: TypeAlias = ListControllers_Response
    Event: TypeAlias = ListControllers_Event

class ListHardwareComponents_Request(Message):
    """controller_manager_msgs/srv/ListHardwareComponents_Request

    # Lists the hardware components.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class ListHardwareComponents_Response(Message):
    """controller_manager_msgs/srv/ListHardwareComponents_Response

    HardwareComponentState[] component
    """
    def __init__(self, *, component: Collection[controller_manager_msgs.msg.HardwareComponentState] = ..., check_fields: bool = ...) -> None: ...
    @property
    def component(self) -> list[controller_manager_msgs.msg.HardwareComponentState]: ...
    @component.setter
    def component(self, value: Collection[controller_manager_msgs.msg.HardwareComponentState]) -> None: ...

class ListHardwareComponents_Event(Message):
    """controller_manager_msgs/srv/ListHardwareComponents_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[controller_manager_msgs.srv.ListHardwareComponents_Request] = ..., response: Collection[controller_manager_msgs.srv.ListHardwareComponents_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[controller_manager_msgs.srv.ListHardwareComponents_Request]: ...
    @request.setter
    def request(self, value: Collection[controller_manager_msgs.srv.ListHardwareComponents_Request]) -> None: ...
    @property
    def response(self) -> list[controller_manager_msgs.srv.ListHardwareComponents_Response]: ...
    @response.setter
    def response(self, value: Collection[controller_manager_msgs.srv.ListHardwareComponents_Response]) -> None: ...

class ListHardwareComponents(Service):
    Request: TypeAlias = ListHardwareComponents_Request
    Response: TypeAlias = ListHardwareComponents_Response
    Event: TypeAlias = ListHardwareComponents_Event

class ListHardwareInterfaces_Request(Message):
    """controller_manager_msgs/srv/ListHardwareInterfaces_Request

    # Lists the interfaces of all hardware.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class ListHardwareInterfaces_Response(Message):
    """controller_manager_msgs/srv/ListHardwareInterfaces_Response

    HardwareInterface[] command_interfaces
    HardwareInterface[] state_interfaces
    """
    def __init__(self, *, command_interfaces: Collection[controller_manager_msgs.msg.HardwareInterface] = ..., state_interfaces: Collection[controller_manager_msgs.msg.HardwareInterface] = ..., check_fields: bool = ...) -> None: ...
    @property
    def command_interfaces(self) -> list[controller_manager_msgs.msg.HardwareInterface]: ...
    @command_interfaces.setter
    def command_interfaces(self, value: Collection[controller_manager_msgs.msg.HardwareInterface]) -> None: ...
    @property
    def state_interfaces(self) -> list[controller_manager_msgs.msg.HardwareInterface]: ...
    @state_interfaces.setter
    def state_interfaces(self, value: Collection[controller_manager_msgs.msg.HardwareInterface]) -> None: ...

class ListHardwareInterfaces_Event(Message):
    """controller_manager_msgs/srv/ListHardwareInterfaces_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[controller_manager_msgs.srv.ListHardwareInterfaces_Request] = ..., response: Collection[controller_manager_msgs.srv.ListHardwareInterfaces_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[controller_manager_msgs.srv.ListHardwareInterfaces_Request]: ...
    @request.setter
    def request(self, value: Collection[controller_manager_msgs.srv.ListHardwareInterfaces_Request]) -> None: ...
    @property
    def response(self) -> list[controller_manager_msgs.srv.ListHardwareInterfaces_Response]: ...
    @response.setter
    def response(self, value: Collection[controller_manager_msgs.srv.ListHardwareInterfaces_Response]) -> None: ...

class ListHardwareInterfaces(Service):
    Request: TypeAlias = ListHardwareInterfaces_Request
    Response: TypeAlias = ListHardwareInterfaces_Response
    Event: TypeAlias = ListHardwareInterfaces_Event

class LoadController_Request(Message):
    """controller_manager_msgs/srv/LoadController_Request

    # Loads a controller.

    string name
    """
    def __init__(self, *, name: str = ..., check_fields: bool = ...) -> None: ...
    name: str

class LoadController_Response(Message):
    """controller_manager_msgs/srv/LoadController_Response

    bool ok
    """
    def __init__(self, *, ok: bool = ..., check_fields: bool = ...) -> None: ...
    ok: bool

class LoadController_Event(Message):
    """controller_manager_msgs/srv/LoadController_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[controller_manager_msgs.srv.LoadController_Request] = ..., response: Collection[controller_manager_msgs.srv.LoadController_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[controller_manager_msgs.srv.LoadController_Request]: ...
    @request.setter
    def request(self, value: Collection[controller_manager_msgs.srv.LoadController_Request]) -> None: ...
    @property
    def response(self) -> list[controller_manager_msgs.srv.LoadController_Response]: ...
    @response.setter
    def response(self, value: Collection[controller_manager_msgs.srv.LoadController_Response]) -> None: ...

class LoadController(Service):
    Request: TypeAlias = LoadController_Request
    Response: TypeAlias = LoadController_Response
    Event: TypeAlias = LoadController_Event

class ReloadControllerLibraries_Request(Message):
    """controller_manager_msgs/srv/ReloadControllerLibraries_Request

    # Loads the libraries of all controllers again.

    bool force_kill  # end controllers that run
    """
    def __init__(self, *, force_kill: bool = ..., check_fields: bool = ...) -> None: ...
    force_kill: bool

class ReloadControllerLibraries_Response(Message):
    """controller_manager_msgs/srv/ReloadControllerLibraries_Response

    bool ok
    """
    def __init__(self, *, ok: bool = ..., check_fields: bool = ...) -> None: ...
    ok: bool

class ReloadControllerLibraries_Event(Message):
    """controller_manager_msgs/srv/ReloadControllerLibraries_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[controller_manager_msgs.srv.ReloadControllerLibraries_Request] = ..., response: Collection[controller_manager_msgs.srv.ReloadControllerLibraries_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[controller_manager_msgs.srv.ReloadControllerLibraries_Request]: ...
    @request.setter
    def request(self, value: Collection[controller_manager_msgs.srv.ReloadControllerLibraries_Request]) -> None: ...
    @property
    def response(self) -> list[controller_manager_msgs.srv.ReloadControllerLibraries_Response]: ...
    @response.setter
    def response(self, value: Collection[controller_manager_msgs.srv.ReloadControllerLibraries_Response]) -> None: ...

class ReloadControllerLibraries(Service):
    Request: TypeAlias = ReloadControllerLibraries_Request
    Response: TypeAlias = ReloadControllerLibraries_Response
    Event: TypeAlias = ReloadControllerLibraries_Event

class SetHardwareComponentState_Request(Message):
    """controller_manager_msgs/srv/SetHardwareComponentState_Request

    # Changes the state of a hardware component.

    string name
    lifecycle_msgs/State target_state  # by id or by label
    """
    def __init__(self, *, name: str = ..., target_state: lifecycle_msgs.msg.State = ..., check_fields: bool = ...) -> None: ...
    name: str
    target_state: lifecycle_msgs.msg.State

class SetHardwareComponentState_Response(Message):
    """controller_manager_msgs/srv/SetHardwareComponentState_Response

    bool ok
    lifecycle_msgs/State state
    """
    def __init__(self, *, ok: bool = ..., state: lifecycle_msgs.msg.State = ..., check_fields: bool = ...) -> None: ...
    ok: bool
    state: lifecycle_msgs.msg.State

class SetHardwareComponentState_Event(Message):
    """controller_manager_msgs/srv/SetHardwareComponentState_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[controller_manager_msgs.srv.SetHardwareComponentState_Request] = ..., response: Collection[controller_manager_msgs.srv.SetHardwareComponentState_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[controller_manager_msgs.srv.SetHardwareComponentState_Request]: ...
    @request.setter
    def request(self, value: Collection[controller_manager_msgs.srv.SetHardwareComponentState_Request]) -> None: ...
    @property
    def response(self) -> list[controller_manager_msgs.srv.SetHardwareComponentState_Response]: ...
    @response.setter
    def response(self, value: Collection[controller_manager_msgs.srv.SetHardwareComponentState_Response]) -> None: ...

class SetHardwareComponentState(Service):
    Request: TypeAlias = SetHardwareComponentState_Request
    Response: TypeAlias = SetHardwareComponentState_Response
    Event: TypeAlias = SetHardwareComponentState_Event

class SwitchController_Request(Message):
    """controller_manager_msgs/srv/SwitchController_Request

    # Starts and stops controllers at the same time.

    string[] activate_controllers
    string[] deactivate_controllers
    int32 strictness  # STRICT: if one controller fails, nothing changes
    int32 BEST_EFFORT=1
    int32 STRICT=2
    int32 AUTO=3
    int32 FORCE_AUTO=4
    bool activate_asap  # do not wait for the next moment at which hardware can change
    builtin_interfaces/Duration timeout  # zero waits for ever
    """
    BEST_EFFORT: Final = 1
    STRICT: Final = 2
    AUTO: Final = 3
    FORCE_AUTO: Final = 4
    def __init__(self, *, activate_controllers: Collection[str] = ..., deactivate_controllers: Collection[str] = ..., strictness: int = ..., activate_asap: bool = ..., timeout: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    @property
    def activate_controllers(self) -> list[str]: ...
    @activate_controllers.setter
    def activate_controllers(self, value: Collection[str]) -> None: ...
    @property
    def deactivate_controllers(self) -> list[str]: ...
    @deactivate_controllers.setter
    def deactivate_controllers(self, value: Collection[str]) -> None: ...
    strictness: int
    activate_asap: bool
    timeout: builtin_interfaces.msg.Duration

class SwitchController_Response(Message):
    """controller_manager_msgs/srv/SwitchController_Response

    bool ok
    string message
    """
    def __init__(self, *, ok: bool = ..., message: str = ..., check_fields: bool = ...) -> None: ...
    ok: bool
    message: str

class SwitchController_Event(Message):
    """controller_manager_msgs/srv/SwitchController_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[controller_manager_msgs.srv.SwitchController_Request] = ..., response: Collection[controller_manager_msgs.srv.SwitchController_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[controller_manager_msgs.srv.SwitchController_Request]: ...
    @request.setter
    def request(self, value: Collection[controller_manager_msgs.srv.SwitchController_Request]) -> None: ...
    @property
    def response(self) -> list[controller_manager_msgs.srv.SwitchController_Response]: ...
    @response.setter
    def response(self, value: Collection[controller_manager_msgs.srv.SwitchController_Response]) -> None: ...

class SwitchController(Service):
    Request: TypeAlias = SwitchController_Request
    Response: TypeAlias = SwitchController_Response
    Event: TypeAlias = SwitchController_Event

class UnloadController_Request(Message):
    """controller_manager_msgs/srv/UnloadController_Request

    # Removes a controller.

    string name
    """
    def __init__(self, *, name: str = ..., check_fields: bool = ...) -> None: ...
    name: str

class UnloadController_Response(Message):
    """controller_manager_msgs/srv/UnloadController_Response

    bool ok
    """
    def __init__(self, *, ok: bool = ..., check_fields: bool = ...) -> None: ...
    ok: bool

class UnloadController_Event(Message):
    """controller_manager_msgs/srv/UnloadController_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[controller_manager_msgs.srv.UnloadController_Request] = ..., response: Collection[controller_manager_msgs.srv.UnloadController_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[controller_manager_msgs.srv.UnloadController_Request]: ...
    @request.setter
    def request(self, value: Collection[controller_manager_msgs.srv.UnloadController_Request]) -> None: ...
    @property
    def response(self) -> list[controller_manager_msgs.srv.UnloadController_Response]: ...
    @response.setter
    def response(self, value: Collection[controller_manager_msgs.srv.UnloadController_Response]) -> None: ...

class UnloadController(Service):
    Request: TypeAlias = UnloadController_Request
    Response: TypeAlias = UnloadController_Response
    Event: TypeAlias = UnloadController_Event
