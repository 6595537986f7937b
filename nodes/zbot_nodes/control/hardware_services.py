"""Services of the controller manager about hardware: its components, interfaces and states."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot_nodes.control.controller import ControllerError
from zbot_nodes.control.hardware import COMPONENT_STATES

from controller_manager_msgs import srv
from controller_manager_msgs.msg import HardwareComponentState, HardwareInterface
from lifecycle_msgs.msg import State

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot_nodes.control.controller_manager import ControllerManager
    from zbot_nodes.control.hardware import SimulatedHardware


class HardwareServices:
    """Answers of a controller manager about its hardware.

    Args:
        manager: The manager.
        hardware: Its hardware.
    """

    def __init__(self, manager: ControllerManager, hardware: SimulatedHardware) -> None:
        self.manager, self.hardware = manager, hardware

    def set_first_states(self) -> None:
        """Bring the hardware components to the states in the parameters. The default is active."""
        for state in ("unconfigured", "inactive"):
            names = self.manager.setting(f"hardware_components_initial_state.{state}", [])
            for name in [names] if isinstance(names, str) else names:
                if name in self.hardware.component_states:
                    self.hardware.set_component_state(name, state)
                elif name:
                    self.manager.get_logger().warn(f"There is no hardware component '{name}'")
        for name, state in self.hardware.component_states.items():
            self.manager.get_logger().info(f"The hardware '{name}' is {state}")

    def create_services(self) -> None:
        """Offer the services."""
        for kind, name, callback in (
            (srv.ListHardwareComponents, "list_hardware_components", self.on_list_components),
            (srv.ListHardwareInterfaces, "list_hardware_interfaces", self.on_list_interfaces),
            (srv.SetHardwareComponentState, "set_hardware_component_state", self.on_set_state),
        ):
            service: Any = kind
            self.manager.create_service(service, f"~/{name}", callback)

    def on_list_components(self, _request: Any, response: Any) -> Any:
        """List the hardware components."""
        response.component = [
            HardwareComponentState(
                name=one.name,
                type=one.kind,
                rw_rate=self.manager.rate_hz,
                plugin_name=one.plugin,
                state=self.component_state(one.name),
                command_interfaces=self.command_interfaces(one.commands),
                state_interfaces=self.state_interfaces(one.states),
            )
            for one in self.hardware.components
        ]
        return response

    def component_state(self, name: str) -> State:
        """Return the state of a hardware component. It is unknown if there is no such component."""
        label = self.hardware.component_states.get(name)
        numbers = {text: number for number, text in COMPONENT_STATES.items()}
        return State(id=numbers[label], label=label) if label else State()

    def on_set_state(self, request: Any, response: Any) -> Any:
        """Change the state of a hardware component."""
        wanted = request.target_state
        state = COMPONENT_STATES.get(wanted.id) or str(wanted.label)
        self.manager.attempt(response, lambda: self.set_state(request.name, state))
        response.state = self.component_state(request.name)
        return response

    def set_state(self, name: str, state: str) -> None:
        """Change the state of a hardware component.

        Raises:
            ControllerError: There is no such component or state, or the component is finalized.
        """
        present = self.hardware.component_states.get(name)
        if present is None:
            known = ", ".join(self.hardware.component_states) or "none"
            raise ControllerError(f"There is no hardware component '{name}': there are {known}")
        if state not in COMPONENT_STATES.values():
            known = ", ".join(COMPONENT_STATES.values())
            raise ControllerError(f"A hardware component has no state '{state}': write {known}")
        if present == "finalized" != state:
            raise ControllerError(f"The hardware component '{name}' is finalized")
        self.hardware.set_component_state(name, state)
        self.manager.get_logger().info(f"The hardware '{name}' is {state}")

    def on_list_interfaces(self, _request: Any, response: Any) -> Any:
        """List the interfaces of the hardware."""
        response.command_interfaces = self.command_interfaces(self.hardware.commands)
        response.state_interfaces = self.state_interfaces(self.hardware.states)
        return response

    def command_interfaces(self, names: Iterable[str]) -> list[HardwareInterface]:
        """Return the messages about command interfaces."""
        claimed = self.manager.claimed()
        closed = {*self.hardware.closed(), *self.manager.unused_references()}
        return [_interface(one, one not in closed, one in claimed) for one in names]

    def state_interfaces(self, names: Iterable[str]) -> list[HardwareInterface]:
        """Return the messages about state interfaces. Controllers cannot claim them."""
        closed = self.hardware.closed()
        return [_interface(one, one not in closed, False) for one in names]


def _interface(name: str, is_available: bool, is_claimed: bool) -> HardwareInterface:
    return HardwareInterface(
        name=name, data_type="double", is_available=is_available, is_claimed=is_claimed
    )
