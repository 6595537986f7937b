# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import controller_manager_msgs.msg
import lifecycle_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class ChainConnection(Message):
    """controller_manager_msgs/msg/ChainConnection

    # Interfaces of another controller that a controller writes to.

    string name  # the other controller
    string[] reference_interfaces
    """
    def __init__(self, *, name: str = ..., reference_interfaces: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    name: str
    @property
    def reference_interfaces(self) -> list[str]: ...
    @reference_interfaces.setter
    def reference_interfaces(self, value: Collection[str]) -> None: ...

class ControllerManagerActivity(Message):
    """controller_manager_msgs/msg/ControllerManagerActivity

    # States of all controllers and hardware components.

    std_msgs/Header header
    NamedLifecycleState[] controllers
    NamedLifecycleState[] hardware_components
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., controllers: Collection[controller_manager_msgs.msg.NamedLifecycleState] = ..., hardware_components: Collection[controller_manager_msgs.msg.NamedLifecycleState] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def controllers(self) -> list[controller_manager_msgs.msg.NamedLifecycleState]: ...
    @controllers.setter
    def controllers(self, value: Collection[controller_manager_msgs.msg.NamedLifecycleState]) -> None: ...
    @property
    def hardware_components(self) -> list[controller_manager_msgs.msg.NamedLifecycleState]: ...
    @hardware_components.setter
    def hardware_components(self, value: Collection[controller_manager_msgs.msg.NamedLifecycleState]) -> None: ...

class ControllerState(Message):
    """controller_manager_msgs/msg/ControllerState

    # A controller, its state and its interfaces.

    string name
    string state  # e.g. active
    string type  # class of the plugin
    bool is_async
    uint16 update_rate  # Hz
    string[] claimed_interfaces  # command interfaces that it uses now
    string[] required_command_interfaces
    string[] required_state_interfaces
    bool is_chainable  # other controllers can write to it
    bool is_chained  # another controller writes to it now
    string[] exported_state_interfaces
    string[] reference_interfaces
    ChainConnection[] chain_connections
    """
    def __init__(self, *, name: str = ..., state: str = ..., type: str = ..., is_async: bool = ..., update_rate: int = ..., claimed_interfaces: Collection[str] = ..., required_command_interfaces: Collection[str] = ..., required_state_interfaces: Collection[str] = ..., is_chainable: bool = ..., is_chained: bool = ..., exported_state_interfaces: Collection[str] = ..., reference_interfaces: Collection[str] = ..., chain_connections: Collection[controller_manager_msgs.msg.ChainConnection] = ..., check_fields: bool = ...) -> None: ...
    name: str
    state: str
    type: str
    is_async: bool
    update_rate: int
    @property
    def claimed_interfaces(self) -> list[str]: ...
    @claimed_interfaces.setter
    def claimed_interfaces(self, value: Collection[str]) -> None: ...
    @property
    def required_command_interfaces(self) -> list[str]: ...
    @required_command_interfaces.setter
    def required_command_interfaces(self, value: Collection[str]) -> None: ...
    @property
    def required_state_interfaces(self) -> list[str]: ...
    @required_state_interfaces.setter
    def required_state_interfaces(self, value: Collection[str]) -> None: ...
    is_chainable: bool
    is_chained: bool
    @property
    def exported_state_interfaces(self) -> list[str]: ...
    @exported_state_interfaces.setter
    def exported_state_interfaces(self, value: Collection[str]) -> None: ...
    @property
    def reference_interfaces(self) -> list[str]: ...
    @reference_interfaces.setter
    def reference_interfaces(self, value: Collection[str]) -> None: ...
    @property
    def chain_connections(self) -> list[controller_manager_msgs.msg.ChainConnection]: ...
    @chain_connections.setter
    def chain_connections(self, value: Collection[controller_manager_msgs.msg.ChainConnection]) -> None: ...

class HardwareComponentState(Message):
    """controller_manager_msgs/msg/HardwareComponentState

    # A hardware component, its state and its interfaces.

    string name
    string type  # actuator, sensor or system
    bool is_async
    uint16 rw_rate  # Hz, of reading and writing
    string plugin_name
    lifecycle_msgs/State state
    HardwareInterface[] command_interfaces
    HardwareInterface[] state_interfaces
    """
    def __init__(self, *, name: str = ..., type: str = ..., is_async: bool = ..., rw_rate: int = ..., plugin_name: str = ..., state: lifecycle_msgs.msg.State = ..., command_interfaces: Collection[controller_manager_msgs.msg.HardwareInterface] = ..., state_interfaces: Collection[controller_manager_msgs.msg.HardwareInterface] = ..., check_fields: bool = ...) -> None: ...
    name: str
    type: str
    is_async: bool
    rw_rate: int
    plugin_name: str
    state: lifecycle_msgs.msg.State
    @property
    def command_interfaces(self) -> list[controller_manager_msgs.msg.HardwareInterface]: ...
    @command_interfaces.setter
    def command_interfaces(self, value: Collection[controller_manager_msgs.msg.HardwareInterface]) -> None: ...
    @property
    def state_interfaces(self) -> list[controller_manager_msgs.msg.HardwareInterface]: ...
    @state_interfaces.setter
    def state_interfaces(self, value: Collection[controller_manager_msgs.msg.HardwareInterface]) -> None: ...

class HardwareInterface(Message):
    """controller_manager_msgs/msg/HardwareInterface

    # An interface of hardware, e.g. joint1/position.

    string name
    string data_type
    bool is_available
    bool is_claimed  # a controller uses it now
    """
    def __init__(self, *, name: str = ..., data_type: str = ..., is_available: bool = ..., is_claimed: bool = ..., check_fields: bool = ...) -> None: ...
    name: str
    data_type: str
    is_available: bool
    is_claimed: bool

class NamedLifecycleState(Message):
    """controller_manager_msgs/msg/NamedLifecycleState

    # A name with the state of its life cycle.

    string name
    lifecycle_msgs/State state
    """
    def __init__(self, *, name: str = ..., state: lifecycle_msgs.msg.State = ..., check_fields: bool = ...) -> None: ...
    name: str
    state: lifecycle_msgs.msg.State
