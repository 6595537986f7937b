"""Bring joints to references by a PID for each joint.

Type:       pid_controller/PidController
Subscribes: ~/reference (control_msgs/MultiDOFCommand), if no other controller commands it;
            ~/measured_state (control_msgs/MultiDOFCommand) with use_external_measured_states
Publishes:  ~/controller_state (control_msgs/MultiDOFStateStamped)
Parameters: see docs/robot-nodes.md
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

from zbot_nodes.control.controller import Controller, ControllerError
from zbot_nodes.control.pid import Pid, read_pid

from control_msgs.msg import MultiDOFCommand, MultiDOFStateStamped, SingleDOFState

_DEPTH = 10


class PidController(Controller):
    """Commands its joints from the differences of references and measured values."""

    kind = "pid_controller/PidController"
    is_chainable = True

    def configure(self) -> None:
        """Read the parameters."""
        self.commanded = self.joints("dof_names")
        self.names = self.setting("reference_and_state_dof_names", []) or self.commanded
        if len(self.names) != len(self.commanded):
            raise ControllerError(
                f"the parameters dof_names and reference_and_state_dof_names of {self.get_name()} "
                "must have equally many names"
            )
        self.interface = str(self.setting("command_interface", ""))
        if not self.interface:
            raise ControllerError(f"the parameter command_interface of {self.get_name()} is empty")
        kinds = self.joints("reference_and_state_interfaces")
        if len(kinds) > 2:
            raise ControllerError(
                f"the parameter reference_and_state_interfaces of {self.get_name()} has more than "
                "two names: write an interface, and perhaps its change per second"
            )
        #: The values, and after them their changes per second if there are two interfaces.
        self.values = [f"{joint}/{kind}" for kind in kinds for joint in self.names]
        self.begins_at_state = bool(self.setting("set_current_state_as_first_setpoint", True))
        self.is_external = bool(self.setting("use_external_measured_states", False))
        self.pids = self.read_gains()
        self.add_post_set_parameters_callback(self.update_gains)
        self.create_topics()

    def read_gains(self) -> list[Pid]:
        """Return a PID for each joint."""
        return [read_pid(self, f"gains.{name}", "feedforward_gain") for name in self.commanded]

    def update_gains(self, _parameters: Any) -> None:
        """Read the gains again, and keep the integral parts."""
        try:
            gains = self.read_gains()
        except ControllerError as error:
            self.get_logger().error(str(error))
            return
        self.pids = [
            replace(new, integral=old.integral, last_error=old.last_error)
            for new, old in zip(gains, self.pids, strict=True)
        ]

    def create_topics(self) -> None:
        """Create the topics."""
        self.received: list[float] = []
        self.external = [math.nan] * len(self.values)
        self.create_subscription(MultiDOFCommand, "~/reference", self.accept, _DEPTH)
        if self.is_external:
            self.create_subscription(MultiDOFCommand, "~/measured_state", self.measure, _DEPTH)
        self.publisher = self.create_publisher(MultiDOFStateStamped, "~/controller_state", _DEPTH)

    # -- interfaces ----------------------------------------------------------------------------

    def command_interfaces(self) -> list[str]:
        """Return the command interface of each joint."""
        return [f"{joint}/{self.interface}" for joint in self.commanded]

    def state_interfaces(self) -> list[str]:
        """Return the interfaces of the measured values."""
        return [] if self.is_external else self.values

    def reference_interfaces(self) -> list[str]:
        """Return the wanted values, which another controller may command."""
        return [f"{self.get_name()}/{value}" for value in self.values]

    def exported_interfaces(self) -> list[str]:
        """Return the measured values, which another controller may read."""
        return self.reference_interfaces()

    # -- messages ------------------------------------------------------------------------------

    def accept(self, message: MultiDOFCommand) -> None:
        """Store the references of a message."""
        self.received = self.ordered(message) or self.received

    def measure(self, message: MultiDOFCommand) -> None:
        """Store the measured values of a message."""
        self.external = self.ordered(message) or self.external

    def ordered(self, message: MultiDOFCommand) -> list[float]:
        """Return a message's values in the order of the joints, or nothing if names are wrong."""
        names = list(message.dof_names) or self.names
        rates = list(message.values_dot) or [math.nan] * len(names)
        if sorted(names) != sorted(self.names) or not len(names) == len(message.values) == len(
            rates
        ):
            self.get_logger().error(
                f"a message needs a value for each of {', '.join(self.names)}",
                throttle_duration_sec=1.0,
            )
            return []
        places = [names.index(name) for name in self.names]
        values = [float(message.values[place]) for place in places]
        return [*values, *(float(rates[place]) for place in places)][: len(self.values)]

    # -- the loop ------------------------------------------------------------------------------

    def activate(self) -> None:
        """Forget old references. The measured values are the first references."""
        self.received = []
        for pid in self.pids:
            pid.reset()
        if self.begins_at_state:
            references = zip(self.reference_interfaces(), self.measured(), strict=True)
            self.hardware.commands.update(references)

    def measured(self) -> list[float]:
        """Return the measured values."""
        if self.is_external:
            return self.external
        return [self.hardware.states[value] for value in self.values]

    def update(self, period_s: float) -> None:
        """Command all joints for one period."""
        commands, names = self.hardware.commands, self.reference_interfaces()
        if not self.is_chained:
            commands.update(zip(names, self.received, strict=False))
            self.received = []
        measured = self.measured()
        self.hardware.states.update(zip(self.exported_interfaces(), measured, strict=True))
        references = [commands[name] for name in names]
        message = MultiDOFStateStamped()
        message.header.stamp = self.get_clock().now().to_msg()
        for place, command in enumerate(self.command_interfaces()):
            state = self.compared(place, references, measured)
            if math.isfinite(state.reference) and math.isfinite(state.feedback):
                commands[command] = self.output(place, references, state, period_s)
            state.time_step, state.output = period_s, commands[command]
            message.dof_states.append(state)
        self.publisher.publish(message)

    def compared(
        self, place: int, references: list[float], measured: list[float]
    ) -> SingleDOFState:
        """Return the reference, the measured value and the error of a joint."""
        wanted, found = references[place], measured[place]
        error = self.pids[place].error(wanted, found)
        state = SingleDOFState(
            name=self.names[place], reference=wanted, feedback=found, error=error
        )
        second = place + len(self.names)
        if second < len(measured):
            state.feedback_dot = measured[second]
            state.error_dot = references[second] - measured[second]
        return state

    def output(
        self, place: int, references: list[float], state: SingleDOFState, period_s: float
    ) -> float:
        """Return the command of a joint."""
        second, rate, wanted = place + len(self.names), None, state.reference
        if second < len(references):
            wanted = references[second] if math.isfinite(references[second]) else 0.0
            rate = state.error_dot if math.isfinite(state.error_dot) else None
        return self.pids[place].command(state.error, period_s, rate=rate, wanted=wanted)
