"""Base class of controllers: nodes that the controller manager loads into its own process."""

from __future__ import annotations

from enum import Enum
from typing import TYPE_CHECKING, Any

import zbot

from rcl_interfaces.msg import ParameterDescriptor

if TYPE_CHECKING:
    from zbot_nodes.control.hardware import SimulatedHardware


class ControllerError(zbot.ZbotError, ValueError):
    """A controller cannot be configured or activated with its parameters."""


class State(Enum):
    """State of a controller, with ROS 2's words."""

    UNCONFIGURED = "unconfigured"
    INACTIVE = "inactive"
    ACTIVE = "active"


class Controller(zbot.Node):
    """Controller of some joints.

    The manager calls `configure` first. It calls `update` in each period while the controller is
    active.

    Args:
        name: The name of the controller and of its node.
        hardware: The hardware with all interfaces.
        description: The robot description.
        options: The options of `zbot.Node`.
    """

    kind = ""  #: the class of ROS 2's plugin, e.g. `diff_drive_controller/DiffDriveController`
    is_chainable = False  #: whether the controller has references for other controllers

    def __init__(
        self, name: str, hardware: SimulatedHardware, description: str, **options: Any
    ) -> None:
        super().__init__(name, **options)
        self.hardware, self.description = hardware, description
        self.state = State.UNCONFIGURED
        self.is_chained = False  #: whether another active controller commands the references

    def setting(self, name: str, default: Any) -> Any:
        """Return a parameter, and declare it at the first call.

        Raises:
            ControllerError: The default is a list, and the value is not a list.
        """
        if not self.has_parameter(name):
            # Without dynamic typing, the default `[]` would make the parameter a byte array.
            self.declare_parameter(name, default, _any_type() if default == [] else None)
        value = self.get_parameter(name).value
        if not isinstance(default, list):
            return value
        if value is None or isinstance(value, (str, bool, int, float)):
            raise ControllerError(f"the parameter {name} of {self.get_name()} must be a list")
        return list(value)

    def number(self, name: str, default: float) -> float:
        """Return a parameter as a float. It may be an integer, because files often have `1`."""
        if not self.has_parameter(name):
            self.declare_parameter(name, default, _any_type())
        value = self.get_parameter(name).value
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise ControllerError(f"the parameter {name} of {self.get_name()} must be a number")
        return float(value)

    def joints(self, name: str) -> list[str]:
        """Return a parameter with names of joints.

        Raises:
            ControllerError: The list is empty.
        """
        found = [str(item) for item in self.setting(name, [])]
        if not found:
            raise ControllerError(f"the parameter {name} of {self.get_name()} is empty")
        return found

    def unknown_parameters(self) -> list[str]:
        """Return the names of parameters that were set but that the controller never reads.

        `type` is a parameter of the manager. The names with `qos_overrides` are those of topics.
        """
        given = self._parameter_overrides
        return sorted(
            name
            for name in given
            if not (self.has_parameter(name) or name == "type" or name.startswith("qos_overrides"))
        )

    def command_interfaces(self) -> list[str]:
        """Return the interfaces to command. Other active controllers cannot command them."""
        return []

    def state_interfaces(self) -> list[str]:
        """Return the interfaces to read."""
        return []

    def reference_interfaces(self) -> list[str]:
        """Return the interfaces `NAME/...` by which other controllers command this one."""
        return []

    def exported_interfaces(self) -> list[str]:
        """Return the interfaces `NAME/...` with states that other controllers can read."""
        return []

    def configure(self) -> None:
        """Read the parameters, and create publishers and subscriptions.

        Raises:
            ControllerError: A parameter cannot be used.
        """

    def activate(self) -> None:
        """Prepare the first update. All interfaces exist."""

    def deactivate(self) -> None:
        """Stop the joints that the controller moves."""

    def update(self, period_s: float) -> None:
        """Read states and write commands for one period."""


def _any_type() -> ParameterDescriptor:
    return ParameterDescriptor(dynamic_typing=True)
