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

from typing import TYPE_CHECKING, Any

import zbot
from zbot.executor.clock import Clock
from zbot.libraries.robot_description.urdf import read_urdf
from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.time import ClockType
from zbot_nodes.control import chain
from zbot_nodes.control.controller import Controller, ControllerError, State
from zbot_nodes.control.controller_types import TYPES
from zbot_nodes.control.hardware import SimulatedHardware, read_components
from zbot_nodes.control.hardware_services import HardwareServices
from zbot_nodes.control.loaded_controllers import LoadedControllers
from zbot_nodes.startup.program import ParameterError, run_node

from controller_manager_msgs import srv
from controller_manager_msgs.msg import ControllerState
from std_msgs.msg import String

if TYPE_CHECKING:
    from zbot.libraries.robot_description.urdf import Mimic
    from zbot_nodes.control.hardware import Component

#: Topic that each simulator has.
_SIMULATED_WORLD = "/simulation/world"
_LOOK_S = 2.0
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
        self.description = ""
        self.use(SimulatedHardware([], {}))  # until there is a description
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
        if self.description:
            return
        try:
            self.begin(message.data)
        except DescriptionError as error:
            self.get_logger().error(str(error))

    def use(self, hardware: SimulatedHardware) -> None:
        """Let controllers that will be loaded read and command a hardware."""
        self.hardware = hardware
        self.controllers = LoadedControllers(hardware, self.get_logger())

    def begin(self, description: str) -> None:
        """Build the hardware, and start the loop and the services."""
        components = read_components(description)
        joints = read_urdf(description).joints
        mimics = {name: joint.mimic for name, joint in joints.items() if joint.mimic is not None}
        self.description = description
        self.use(self.new_hardware(components, mimics))
        if not components:
            self.get_logger().warn("The robot description has no <ros2_control>: nothing moves")
        self.warn_of_drivers()
        self.set_first_states()
        self.create_services()
        HardwareServices(self, self.hardware, self.controllers, self.rate_hz).create_services()
        self.start_loop()

    def new_hardware(
        self, components: list[Component], mimics: dict[str, Mimic]
    ) -> SimulatedHardware:
        """Return the hardware that controllers read and command."""
        return SimulatedHardware(components, mimics)

    def warn_of_drivers(self) -> None:
        """Say which drivers of the description do not run here."""
        for component in self.hardware.components:
            if not component.is_mock:
                self.get_logger().warn(
                    f"{component.plugin} is a compiled driver, which does not run here: the "
                    f"hardware '{component.name}' is simulated"
                )

    def start_loop(self) -> None:
        """Call `update` at the rate of the manager."""
        self.create_timer(1 / self.rate_hz, self.update)
        real = Clock(clock_type=ClockType.STEADY_TIME)
        self._look = self.create_timer(_LOOK_S, self.notice_a_simulator, clock=real)

    def notice_a_simulator(self) -> None:
        """Say once that the bodies of a simulator are not the hardware of this manager."""
        if not self.count_publishers(_SIMULATED_WORLD):
            return
        self._look.cancel()
        self.get_logger().warn(
            "A simulator runs in this domain, but this manager moves no bodies in it: a manager in "
            "the simulator does, which <plugin filename='gz_ros2_control-system' "
            "name='gz_ros2_control::GazeboSimROS2ControlPlugin'/> in the <gazebo> tag of the robot "
            "description starts"
        )

    def set_first_states(self) -> None:
        """Bring the hardware components to the states in the parameters. The default is active."""
        states = self.hardware.component_states
        for state in ("unconfigured", "inactive"):
            names = self.setting(f"hardware_components_initial_state.{state}", [])
            for name in [names] if isinstance(names, str) else names:
                if name in states:
                    self.hardware.set_component_state(name, state)
                elif name:
                    self.get_logger().warn(f"There is no hardware component '{name}'")
        for name, state in states.items():
            self.get_logger().info(f"The hardware '{name}' is {state}")

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
        now_ns = self.get_clock().now().nanoseconds
        before_ns, self.updated_ns = self.updated_ns, now_ns
        period_s = (now_ns - before_ns) / 1e9
        if not before_ns or period_s <= 0:
            return  # the first period, or a jump back of simulated time
        self.hardware.read(period_s)
        for controller in self.controllers.active:
            controller.update(period_s)

    # -- controllers ---------------------------------------------------------------------------

    def load(self, name: str) -> None:
        """Create the node of a controller.

        Raises:
            ControllerError: The controller has no type, or its type is unknown.
        """
        if name in self.controllers.by_name:
            raise ControllerError(f"A controller named '{name}' was already loaded")
        kind = str(self.setting(f"{name}.type", ""))
        if not kind:
            raise ControllerError(f"The 'type' param was not defined for '{name}'")
        if kind not in TYPES:
            known = ", ".join(sorted(TYPES))
            raise ControllerError(f"There is no controller type '{kind}': there are {known}")
        node = TYPES[kind](
            name,
            self.hardware,
            self.description,
            namespace=self.get_namespace(),
            cli_args=self.arguments_of(name),
            **self.options,
        )
        self.controllers.by_name[name] = node
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
        return words + [word for word in " ".join(more).split() if word != "--ros-args"]

    def configure(self, name: str) -> None:
        """Configure a controller that is loaded.

        Raises:
            ControllerError: There is no such controller, it is active, or it cannot be configured.
        """
        controller = self.controllers.known(name)
        if controller.state is State.ACTIVE:
            raise ControllerError(f"Controller '{name}' can not be configured from 'active' state")
        if controller.state is State.INACTIVE:
            self.cleanup(name)
            controller = self.controllers.known(name)
        try:
            controller.configure()
        except Exception:
            self.cleanup(name)  # removes the topics that the node has already created
            raise
        self.hardware.add(controller.reference_interfaces(), controller.exported_interfaces())
        controller.state = State.INACTIVE
        self.get_logger().info(f"Configuring controller '{name}'")
        self.name_unknown(controller)

    def name_unknown(self, controller: Controller) -> None:
        """Warn of values for parameters that a controller does not have. They have no effect."""
        # A value for all nodes of the process, e.g. `/**` in a file, is also one of the manager.
        unknown = [name for name in controller.unknown_parameters() if not self.has_parameter(name)]
        if unknown:
            self.get_logger().warn(
                f"Controller '{controller.get_name()}' does not use the parameters "
                f"{', '.join(unknown)}"
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
        controller = self.controllers.known(name)
        if controller.state is State.ACTIVE:
            raise ControllerError(f"Could not unload controller '{name}' because it is active")
        if controller.state is State.INACTIVE:
            self.hardware.remove(
                controller.reference_interfaces(), controller.exported_interfaces()
            )
        del self.controllers.by_name[name]
        if self.executor is not None:
            self.executor.remove_node(controller)
        controller.destroy_node()

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
        return self.attempt(
            response, lambda: self.controllers.switch(begin, end, is_strict=is_strict)
        )

    def on_list(self, _request: Any, response: Any) -> Any:
        """List the controllers."""
        links = chain.links(self.controllers.by_name.values())
        response.controller = [
            self.described(controller, links) for controller in self.controllers.by_name.values()
        ]
        return response

    def described(self, controller: Controller, links: list[chain.Link]) -> ControllerState:
        """Return the message about a controller."""
        message = ControllerState(
            name=controller.get_name(),
            state=controller.state.value,
            type=controller.kind,
            update_rate=self.rate_hz,
            is_chainable=controller.is_chainable,
            is_chained=controller.is_chained,
        )
        if controller.state is not State.UNCONFIGURED:
            message.required_command_interfaces = controller.command_interfaces()
            message.required_state_interfaces = controller.state_interfaces()
            start = f"{controller.get_name()}/"
            for field, names in (
                ("reference_interfaces", controller.reference_interfaces()),
                ("exported_state_interfaces", controller.exported_interfaces()),
            ):
                setattr(message, field, [name.removeprefix(start) for name in names])
        if controller.state is State.ACTIVE:
            message.claimed_interfaces = controller.command_interfaces()
        message.chain_connections = [link.message() for link in links if link.user is controller]
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
