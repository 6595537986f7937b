"""Load controllers, and let them read and command the joints of a simulated hardware.

Run:        zbot run controller_manager ros2_control_node --ros-args --params-file robot.yaml
Subscribes: robot_description (std_msgs/String), unless the parameter robot_description is set
Serves:     ~/load_controller, ~/configure_controller, ~/switch_controller, ~/unload_controller,
            ~/cleanup_controller, ~/list_controllers, ~/list_controller_types,
            ~/list_hardware_components, ~/list_hardware_interfaces,
            ~/set_hardware_component_state (controller_manager_msgs)
Parameters: update_rate (100 Hz), robot_description (""), NAME.type: the class of a controller,
            hardware_components_initial_state.unconfigured and .inactive: names of components
"""

from __future__ import annotations

import math
from typing import Any

import zbot
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot_nodes.control import chain
from zbot_nodes.control.controller import Controller, ControllerError, State
from zbot_nodes.control.controller_types import TYPES
from zbot_nodes.control.hardware import SimulatedHardware, read_components
from zbot_nodes.control.hardware_services import HardwareServices
from zbot_nodes.description.urdf import read_urdf
from zbot_nodes.description.xml_text import DescriptionError
from zbot_nodes.startup.program import ParameterError, run_node

from controller_manager_msgs import srv
from controller_manager_msgs.msg import ControllerState
from std_msgs.msg import String

_KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class ControllerManager(zbot.Node):
    """Runs the loop: read the hardware, update the controllers, write the commands.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        self.options = {key: options[key] for key in ("context",) if key in options}
        super().__init__(
            "controller_manager",
            allow_undeclared_parameters=True,
            automatically_declare_parameters_from_overrides=True,
            **options,
        )
        rate_hz = self.setting("update_rate", 100)
        if not isinstance(rate_hz, int) or rate_hz <= 0:
            raise ParameterError("the parameter update_rate must be a whole number above 0")
        self.rate_hz = rate_hz
        self.controllers: dict[str, Controller] = {}
        self.active: list[Controller] = []  # in the order of their updates
        self.hardware: SimulatedHardware | None = None
        self.description = ""
        self.updated_ns = 0
        text = str(self.setting("robot_description", ""))
        if text:
            self.begin(text)
        else:
            self.get_logger().info("Waiting for data on 'robot_description' topic")
            self.create_subscription(String, "robot_description", self.accept, _KEPT)

    def setting(self, name: str, default: Any) -> Any:
        """Declare a parameter unless it was set, and return its value."""
        if not self.has_parameter(name):
            self.declare_parameter(name, default)
        return self.get_parameter(name).value

    def accept(self, message: String) -> None:
        """Use the first valid description of the topic."""
        if self.hardware is not None:
            return
        try:
            self.begin(message.data)
        except DescriptionError as error:
            self.get_logger().error(str(error))

    def begin(self, description: str) -> None:
        """Build the hardware, and start the loop and the services."""
        components = read_components(description)
        joints = read_urdf(description).joints
        mimics = {name: one.mimic for name, one in joints.items() if one.mimic is not None}
        self.hardware, self.description = SimulatedHardware(components, mimics), description
        if not components:
            self.get_logger().warn("The robot description has no <ros2_control>: nothing moves")
        for one in components:
            if not one.is_mock:
                self.get_logger().warn(
                    f"{one.plugin} is a compiled driver, which does not run here: the hardware "
                    f"'{one.name}' is simulated"
                )
        services = HardwareServices(self, self.hardware)
        services.set_first_states()
        self.create_services()
        services.create_services()
        self.create_timer(1 / self.rate_hz, self.update)

    def create_services(self) -> None:
        """Offer the services of ROS 2's controller manager."""
        for kind, name, callback in (
            (srv.LoadController, "load_controller", self.on_load),
            (srv.ConfigureController, "configure_controller", self.on_configure),
            (srv.CleanupController, "cleanup_controller", self.on_cleanup),
            (srv.UnloadController, "unload_controller", self.on_unload),
            (srv.SwitchController, "switch_controller", self.on_switch),
            (srv.ListControllers, "list_controllers", self.on_list),
            (srv.ListControllerTypes, "list_controller_types", self.on_list_types),
        ):
            service: Any = kind
            self.create_service(service, f"~/{name}", callback)

    # -- the loop ------------------------------------------------------------------------------

    def update(self) -> None:
        """Run one period of the loop."""
        assert self.hardware is not None
        now_ns = self.get_clock().now().nanoseconds
        before_ns, self.updated_ns = self.updated_ns, now_ns
        period_s = (now_ns - before_ns) / 1e9
        if not before_ns or period_s <= 0:
            return  # the first period, or a jump back of simulated time
        self.hardware.read(period_s)
        for one in self.active:
            one.update(period_s)

    def claimed(self) -> set[str]:
        """Return the command interfaces of the active controllers."""
        return {name for one in self.active for name in one.command_interfaces()}

    # -- controllers ---------------------------------------------------------------------------

    def load(self, name: str) -> None:
        """Create the node of a controller.

        Raises:
            ControllerError: The controller has no type, or its type is unknown.
        """
        if name in self.controllers:
            raise ControllerError(f"A controller named '{name}' was already loaded")
        kind = str(self.setting(f"{name}.type", ""))
        if not kind:
            raise ControllerError(f"The 'type' param was not defined for '{name}'")
        if kind not in TYPES:
            known = ", ".join(sorted(TYPES))
            raise ControllerError(f"There is no controller type '{kind}': there are {known}")
        assert self.hardware is not None
        node = TYPES[kind](
            name,
            self.hardware,
            self.description,
            namespace=self.get_namespace(),
            cli_args=self.arguments_of(name),
            **self.options,
        )
        self.controllers[name] = node
        if self.executor is not None:
            self.executor.add_node(node)
        self.get_logger().info(f"Loading controller '{name}'")

    def arguments_of(self, name: str) -> list[str]:
        """Return a controller's ROS arguments: name, namespace, and the spawner's arguments."""
        words = ["--ros-args", "-r", f"__node:={name}", "-r", f"__ns:={self.get_namespace()}"]
        files = self.setting(f"{name}.params_file", "")
        for path in [files] if isinstance(files, str) else files:
            words += ["--params-file", path] if path else []
        extra = self.setting(f"{name}.node_options_args", "")
        more = [extra] if isinstance(extra, str) else list(extra)
        return words + [one for one in " ".join(more).split() if one != "--ros-args"]

    def configure(self, name: str) -> None:
        """Configure a controller that is loaded.

        Raises:
            ControllerError: There is no such controller, it is active, or it cannot be configured.
        """
        one = self.known(name)
        if one.state is State.ACTIVE:
            raise ControllerError(f"Controller '{name}' can not be configured from 'active' state")
        if one.state is State.INACTIVE:
            self.cleanup(name)
            one = self.known(name)
        try:
            one.configure()
        except Exception:
            self.cleanup(name)  # removes the topics that the node has already created
            raise
        assert self.hardware is not None
        self.hardware.add(one.reference_interfaces(), one.exported_interfaces())
        one.state = State.INACTIVE
        self.get_logger().info(f"Configuring controller '{name}'")
        self.name_unknown(one)

    def name_unknown(self, one: Controller) -> None:
        """Warn of values for parameters that a controller does not have. They have no effect."""
        # A value for all nodes of the process, e.g. `/**` in a file, is also one of the manager.
        unknown = [name for name in one.unknown_parameters() if not self.has_parameter(name)]
        if unknown:
            self.get_logger().warn(
                f"Controller '{one.get_name()}' does not use the parameters {', '.join(unknown)}"
            )

    def cleanup(self, name: str) -> None:
        """Undo the configuration of a controller: destroy its node, and create the node again.

        Raises:
            ControllerError: There is no such controller, or it is active.
        """
        self.unload(name)
        self.load(name)

    def unload(self, name: str) -> None:
        """Remove a controller.

        Raises:
            ControllerError: There is no such controller, or it is active.
        """
        one = self.known(name)
        if one.state is State.ACTIVE:
            raise ControllerError(f"Could not unload controller '{name}' because it is active")
        if one.state is State.INACTIVE and self.hardware is not None:
            self.hardware.remove(one.reference_interfaces(), one.exported_interfaces())
        del self.controllers[name]
        if self.executor is not None:
            self.executor.remove_node(one)
        one.destroy_node()

    def known(self, name: str) -> Controller:
        """Return a controller that is loaded."""
        if name not in self.controllers:
            raise ControllerError(f"Could not find controller with name '{name}'")
        return self.controllers[name]

    def switch(self, begin: list[str], end: list[str], *, is_strict: bool) -> None:
        """Activate and deactivate controllers.

        Raises:
            ControllerError: The switch is strict, and a controller cannot be activated or
                deactivated. Then nothing changes.
        """
        starting: list[Controller] = []
        stopping: list[Controller] = []
        for names, found, check in ((end, stopping, self.stops), (begin, starting, self.starts)):
            for name in names:
                try:
                    check(name, stopping, starting)
                except ControllerError as error:
                    self.refuse(str(error), is_strict=is_strict)
                else:
                    found.append(self.controllers[name])
        self.keep_chains(starting, stopping, is_strict=is_strict)
        for one in stopping:
            one.deactivate()
            one.state = State.INACTIVE
            self.get_logger().info(f"Deactivated controller '{one.get_name()}'")
        for one in starting:
            self.activate(one)
            one.state = State.ACTIVE
            self.get_logger().info(f"Activated controller '{one.get_name()}'")
        active = [one for one in self.controllers.values() if one.state is State.ACTIVE]
        self.active = chain.in_order(active)
        self.connect_chains()

    def refuse(self, reason: str, *, is_strict: bool) -> None:
        """Refuse the whole switch if it is strict. Otherwise only warn."""
        if is_strict:
            raise ControllerError(reason)
        self.get_logger().warn(reason)

    def stops(self, name: str, _stopping: list[Controller], _starting: list[Controller]) -> None:
        """Check that a controller can be deactivated."""
        if self.known(name).state is not State.ACTIVE:
            raise ControllerError(f"Controller '{name}' can not be deactivated: it is not active")

    def starts(self, name: str, stopping: list[Controller], starting: list[Controller]) -> None:
        """Check that a controller can be activated with others, after some have stopped."""
        one = self.known(name)
        if one.state is not State.INACTIVE and one not in stopping:
            raise ControllerError(
                f"Controller '{name}' can not be activated from its state {one.state.value}"
            )
        assert self.hardware is not None
        missing = [
            *(set(one.command_interfaces()) - set(self.hardware.commands)),
            *(set(one.state_interfaces()) - set(self.hardware.states)),
        ]
        if missing:
            raise ControllerError(
                f"Controller '{name}' needs the interface '{min(missing)}', which neither the "
                "hardware nor another configured controller has"
            )
        needed = {*one.command_interfaces(), *one.state_interfaces()}
        closed = {name: owner for name, owner in self.hardware.closed().items() if name in needed}
        if closed:
            raise ControllerError(
                f"Controller '{name}' needs the interface '{min(closed)}', but the hardware "
                f"'{closed[min(closed)]}' is not configured"
            )
        others = [other for other in self.active if other not in stopping] + starting
        taken = {name for other in others for name in other.command_interfaces()}
        taken &= set(one.command_interfaces())
        if taken:
            raise ControllerError(
                f"Controller '{name}' can not be activated: another controller commands "
                f"'{min(taken)}'"
            )

    # -- chains --------------------------------------------------------------------------------

    def keep_chains(
        self, starting: list[Controller], stopping: list[Controller], *, is_strict: bool
    ) -> None:
        """Leave out controllers that would break a chain.

        Raises:
            ControllerError: The switch is strict, and would break a chain.
        """
        while True:
            active = [one for one in self.active if one not in stopping] + starting
            broken = chain.broken_link(self.controllers.values(), active)
            if broken is None:
                return
            self.refuse(broken.reason(starting), is_strict=is_strict)
            if broken.user in starting:
                starting.remove(broken.user)
            else:
                stopping.remove(broken.provider)

    def connect_chains(self) -> None:
        """Tell controllers whether another controller commands them from now on."""
        claimed = self.claimed()
        for one in self.controllers.values():
            is_chained = one in self.active and not claimed.isdisjoint(one.reference_interfaces())
            if is_chained != one.is_chained:
                one.is_chained = is_chained
                if one in self.active:
                    self.activate(one)

    def activate(self, one: Controller) -> None:
        """Forget a controller's references, and prepare its first update."""
        assert self.hardware is not None
        references = one.reference_interfaces()
        self.hardware.commands.update(dict.fromkeys(references, math.nan))
        one.activate()

    def unused_references(self) -> set[str]:
        """Return the references that no controller commands now."""
        ready = (one for one in self.controllers.values() if one.state is not State.UNCONFIGURED)
        return {name for one in ready if not one.is_chained for name in one.reference_interfaces()}

    # -- services ------------------------------------------------------------------------------

    def attempt(self, response: Any, act: Any) -> Any:
        """Call `act` for a request, and set `ok` in the response."""
        try:
            act()
        except Exception as error:  # noqa: BLE001 - the other controllers go on, as in ROS 2
            text = str(error) if isinstance(error, zbot.ZbotError) else repr(error)
            self.get_logger().error(text)
            response.ok = False
            if hasattr(response, "message"):
                response.message = text
        else:
            response.ok = True
        return response

    def on_load(self, request: Any, response: Any) -> Any:
        """Load a controller."""
        return self.attempt(response, lambda: self.load(request.name))

    def on_configure(self, request: Any, response: Any) -> Any:
        """Configure a controller."""
        return self.attempt(response, lambda: self.configure(request.name))

    def on_cleanup(self, request: Any, response: Any) -> Any:
        """Undo the configuration of a controller."""
        return self.attempt(response, lambda: self.cleanup(request.name))

    def on_unload(self, request: Any, response: Any) -> Any:
        """Remove a controller."""
        return self.attempt(response, lambda: self.unload(request.name))

    def on_switch(self, request: Any, response: Any) -> Any:
        """Activate and deactivate controllers."""
        is_strict = request.strictness != srv.SwitchController.Request.BEST_EFFORT
        begin, end = list(request.activate_controllers), list(request.deactivate_controllers)
        return self.attempt(response, lambda: self.switch(begin, end, is_strict=is_strict))

    def on_list(self, _request: Any, response: Any) -> Any:
        """List the controllers."""
        links = chain.links(self.controllers.values())
        response.controller = [self.described(one, links) for one in self.controllers.values()]
        return response

    def described(self, one: Controller, links: list[chain.Link]) -> ControllerState:
        """Return the message about a controller."""
        message = ControllerState(
            name=one.get_name(),
            state=one.state.value,
            type=one.kind,
            update_rate=self.rate_hz,
            is_chainable=one.is_chainable,
            is_chained=one.is_chained,
        )
        if one.state is not State.UNCONFIGURED:
            message.required_command_interfaces = one.command_interfaces()
            message.required_state_interfaces = one.state_interfaces()
            start = f"{one.get_name()}/"
            for field, names in (
                ("reference_interfaces", one.reference_interfaces()),
                ("exported_state_interfaces", one.exported_interfaces()),
            ):
                setattr(message, field, [name.removeprefix(start) for name in names])
        if one.state is State.ACTIVE:
            message.claimed_interfaces = one.command_interfaces()
        message.chain_connections = [link.message() for link in links if link.user is one]
        return message

    def on_list_types(self, _request: Any, response: Any) -> Any:
        """List the types of controllers."""
        response.types = sorted(TYPES)
        response.base_classes = ["controller_interface::ControllerInterface"] * len(TYPES)
        return response


def main() -> None:
    """Run until Ctrl-C."""
    run_node(ControllerManager)


if __name__ == "__main__":
    main()
