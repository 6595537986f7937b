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

    import zbot
    from zbot_nodes.control.hardware import SimulatedHardware
    from zbot_nodes.control.loaded_controllers import LoadedControllers


class HardwareServices:
    """Answers of a controller manager about its hardware.

    Args:
        node: The node of the manager.
        hardware: Its hardware.
        controllers: Its controllers.
        rate_hz: How often the manager reads and writes the hardware.
    """

    def __init__(
        self,
        node: zbot.Node,
        hardware: SimulatedHardware,
        controllers: LoadedControllers,
        rate_hz: int,
    ) -> None:
        self.node, self.hardware, self.controllers = node, hardware, controllers
        self.rate_hz = rate_hz

    def create_services(self) -> None:
        """Offer the services."""
        for kind, name, callback in (
            (srv.ListHardwareComponents, "list_hardware_components", self.on_list_components),
            (srv.ListHardwareInterfaces, "list_hardware_interfaces", self.on_list_interfaces),
            (srv.SetHardwareComponentState, "set_hardware_component_state", self.on_set_state),
        ):
            service: Any = kind
            self.node.create_service(service, f"~/{name}", callback)

    def on_list_components(self, _request: Any, response: Any) -> Any:
        """List the hardware components."""
        response.component = [
            HardwareComponentState(
                name=component.name,
                type=component.kind,
                rw_rate=self.rate_hz,
                plugin_name=component.plugin,
                state=self.component_state(component.name),
                command_interfaces=self.command_interfaces(component.commands),
                state_interfaces=self.state_interfaces(component.states),
            )
            for component in self.hardware.components
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
        try:
            self.set_state(request.name, state)
        except ControllerError as error:
            self.node.get_logger().error(str(error))
        else:
            response.ok = True
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
        self.node.get_logger().info(f"The hardware '{name}' is {state}")

    def on_list_interfaces(self, _request: Any, response: Any) -> Any:
        """List the interfaces of the hardware."""
        response.command_interfaces = self.command_interfaces(self.hardware.commands)
        response.state_interfaces = self.state_interfaces(self.hardware.states)
        return response

    def command_interfaces(self, names: Iterable[str]) -> list[HardwareInterface]:
        """Return the messages about command interfaces."""
        claimed = self.controllers.claimed()
        closed = {*self.hardware.closed(), *self.controllers.unused_references()}
        return [_interface(name, name not in closed, name in claimed) for name in names]

    def state_interfaces(self, names: Iterable[str]) -> list[HardwareInterface]:
        """Return the messages about state interfaces. Controllers cannot claim them."""
        closed = self.hardware.closed()
        return [_interface(name, name not in closed, False) for name in names]


def _interface(name: str, is_available: bool, is_claimed: bool) -> HardwareInterface:
    return HardwareInterface(
        name=name, data_type="double", is_available=is_available, is_claimed=is_claimed
    )
