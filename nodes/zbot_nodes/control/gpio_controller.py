"""Command and publish the inputs and outputs (GPIO) of the hardware.

Type:       gpio_controllers/GpioCommandController
Subscribes: ~/commands (control_msgs/DynamicInterfaceGroupValues)
Publishes:  ~/gpio_states (control_msgs/DynamicInterfaceGroupValues)
Parameters: gpios, command_interfaces.GPIO.interfaces, state_interfaces.GPIO.interfaces
"""

from __future__ import annotations

from zbot_nodes.control.controller import Controller, State

from control_msgs.msg import DynamicInterfaceGroupValues, InterfaceValue

_DEPTH = 10


class GpioCommandController(Controller):
    """Writes the values of messages to outputs, and publishes the states of inputs and outputs."""

    kind = "gpio_controllers/GpioCommandController"

    def configure(self) -> None:
        """Read the names of the interfaces."""
        names = self.joints("gpios")
        self.outputs = {name: self.interfaces("command_interfaces", name) for name in names}
        self.inputs = {name: self.interfaces("state_interfaces", name) for name in names}
        if not any(self.inputs.values()):
            self.inputs = {name: self.described(name) for name in names}
        self.wanted: dict[str, float] = {}
        kind = DynamicInterfaceGroupValues
        self.publisher = self.create_publisher(kind, "~/gpio_states", _DEPTH)
        self.create_subscription(kind, "~/commands", self.accept, _DEPTH)

    def interfaces(self, group: str, name: str) -> list[str]:
        """Return the interfaces of a GPIO in a group of parameters."""
        return [str(interface) for interface in self.setting(f"{group}.{name}.interfaces", [])]

    def described(self, name: str) -> list[str]:
        """Return the state interfaces that the robot description has for a GPIO."""
        start = f"{name}/"
        return [
            state.removeprefix(start) for state in self.hardware.states if state.startswith(start)
        ]

    def command_interfaces(self) -> list[str]:
        """Return the outputs."""
        return [f"{name}/{interface}" for name, own in self.outputs.items() for interface in own]

    def state_interfaces(self) -> list[str]:
        """Return the inputs and outputs whose states are published."""
        return [f"{name}/{interface}" for name, own in self.inputs.items() for interface in own]

    def activate(self) -> None:
        """Forget old commands."""
        self.wanted = {}

    def accept(self, message: DynamicInterfaceGroupValues) -> None:
        """Store the values of a message. Unknown interfaces are named in the log."""
        if self.state is not State.ACTIVE:
            return
        known = set(self.command_interfaces())
        for name, group in zip(message.interface_groups, message.interface_values, strict=False):
            for interface, value in zip(group.interface_names, group.values, strict=False):
                if f"{name}/{interface}" in known:
                    self.wanted[f"{name}/{interface}"] = value
                else:
                    text = f"there is no command interface '{name}/{interface}'"
                    self.get_logger().error(text, throttle_duration_sec=1.0)

    def update(self, period_s: float) -> None:
        """Write the outputs, and publish the states."""
        del period_s
        self.hardware.commands.update(self.wanted)
        states = self.hardware.states
        message = DynamicInterfaceGroupValues(interface_groups=list(self.inputs))
        message.header.stamp = self.get_clock().now().to_msg()
        message.interface_values = [
            InterfaceValue(
                interface_names=own, values=[states[f"{name}/{interface}"] for interface in own]
            )
            for name, own in self.inputs.items()
        ]
        self.publisher.publish(message)
