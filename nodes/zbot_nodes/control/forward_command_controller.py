"""Forward commands to joints.

Types:      forward_command_controller/ForwardCommandController,
            forward_command_controller/MultiInterfaceForwardCommandController,
            passthrough_controller/PassthroughController,
            position_controllers/JointGroupPositionController,
            velocity_controllers/JointGroupVelocityController,
            effort_controllers/JointGroupEffortController
Subscribes: ~/commands (std_msgs/Float64MultiArray): a value for each joint or interface
Parameters: joints; interface_name (ForwardCommandController only); joint and interface_names
            (MultiInterfaceForwardCommandController); interfaces (PassthroughController)
"""

from __future__ import annotations

import math

from zbot_nodes.control.controller import Controller, ControllerError, State

from std_msgs.msg import Float64MultiArray

_DEPTH = 10


class ForwardCommandController(Controller):
    """Writes the last message to the interfaces of its joints."""

    kind = "forward_command_controller/ForwardCommandController"
    interface = ""

    def configure(self) -> None:
        """Read the names of the interfaces."""
        self.names = self.read_names()
        self.values: list[float] = []
        self.create_subscription(Float64MultiArray, "~/commands", self.accept, _DEPTH)

    def read_names(self) -> list[str]:
        """Return the interfaces, in the order of the values."""
        interface = self.interface or str(self.setting("interface_name", ""))
        if not interface:
            raise ControllerError(f"the parameter interface_name of {self.get_name()} is empty")
        return [f"{joint}/{interface}" for joint in self.joints("joints")]

    def command_interfaces(self) -> list[str]:
        """Return one interface of each joint."""
        return self.names

    def activate(self) -> None:
        """Forget old commands."""
        self.values = []

    def accept(self, message: Float64MultiArray) -> None:
        """Store a command."""
        values = list(message.data)
        if self.state is not State.ACTIVE:
            return
        text = ""
        if len(values) != len(self.names):
            text = f"command has {len(values)} values, but there are {len(self.names)} joints"
        elif not all(map(math.isfinite, values)):
            text = f"command has values that are not finite: {values}"
        if text:
            self.get_logger().error(text, throttle_duration_sec=1.0)
            return
        self.values = values

    def update(self, period_s: float) -> None:
        """Write the last command."""
        del period_s
        self.hardware.commands.update(zip(self.names, self.values, strict=False))


class MultiInterfaceForwardCommandController(ForwardCommandController):
    """Commands several interfaces of one joint."""

    kind = "forward_command_controller/MultiInterfaceForwardCommandController"

    def read_names(self) -> list[str]:
        """Return the interfaces, in the order of the values."""
        joint = str(self.setting("joint", ""))
        if not joint:
            raise ControllerError(f"the parameter joint of {self.get_name()} is empty")
        return [f"{joint}/{interface}" for interface in self.joints("interface_names")]


class PassthroughController(ForwardCommandController):
    """Writes messages, or the commands of another controller, to its interfaces."""

    kind = "passthrough_controller/PassthroughController"
    is_chainable = True

    def read_names(self) -> list[str]:
        """Return the interfaces, in the order of the values."""
        return self.joints("interfaces")

    def reference_interfaces(self) -> list[str]:
        """Return a reference for each interface."""
        return [f"{self.get_name()}/{name}" for name in self.names]

    def update(self, period_s: float) -> None:
        """Write the references that were commanded."""
        del period_s
        commands, references = self.hardware.commands, self.reference_interfaces()
        if not self.is_chained:
            commands.update(zip(references, self.values, strict=False))
        for name, reference in zip(self.names, references, strict=True):
            if math.isfinite(commands[reference]):
                commands[name] = commands[reference]


class JointGroupPositionController(ForwardCommandController):
    """Commands positions."""

    kind = "position_controllers/JointGroupPositionController"
    interface = "position"


class JointGroupVelocityController(ForwardCommandController):
    """Commands velocities. Stops the joints when it is deactivated."""

    kind = "velocity_controllers/JointGroupVelocityController"
    interface = "velocity"

    def deactivate(self) -> None:
        """Stop the joints."""
        self.hardware.commands.update(dict.fromkeys(self.names, 0.0))


class JointGroupEffortController(ForwardCommandController):
    """Commands efforts. Sets them to 0 when it is deactivated."""

    kind = "effort_controllers/JointGroupEffortController"
    interface = "effort"

    def deactivate(self) -> None:
        """Set the efforts of the joints to 0."""
        self.hardware.commands.update(dict.fromkeys(self.names, 0.0))
