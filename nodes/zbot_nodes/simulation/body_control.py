"""Controller manager in the simulator's process, as Gazebo's plugin starts it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot_nodes.control.controller_manager import ControllerManager
from zbot_nodes.simulation.body_hardware import BodyHardware

if TYPE_CHECKING:
    from zbot.simulation.node.simulator import Simulator
    from zbot.simulation.robots.equipment import Control
    from zbot.simulation.robots.robot import Robot

_SIM_TIME = ("-p", "use_sim_time:=true")


class BodyControl(ControllerManager):
    """Controller manager whose hardware is a robot in the simulator.

    The simulator calls `update` in its own time, so no period is lost when the machine is busy.

    Args:
        simulator: The simulator.
        robot: The robot.
    """

    def __init__(self, simulator: Simulator, robot: Robot) -> None:
        self._simulator, self._robot = simulator, robot
        control = robot.model.equipment.control
        words = [] if control is None else arguments_of(control)
        # The arguments of the process are for the simulator.
        own = {"context": simulator.context, "use_global_arguments": False}
        super().__init__(cli_args=words, **own)
        self.options = own
        if not self.description:
            self.begin(robot.model.text)

    def new_hardware(self, components: Any, mimics: Any) -> BodyHardware:
        """Return the hardware that is the robot."""
        return BodyHardware(components, mimics, self._robot, self._simulator.world)

    def start_loop(self) -> None:
        """Do nothing: the simulator calls `update`."""

    def warn_of_drivers(self) -> None:
        """Do nothing: the hardware of the description is the simulator."""

    def update(self) -> None:
        """Run one period of the loop."""
        now_ns = self._simulator.world.time_ns
        before_ns, self.updated_ns = self.updated_ns, now_ns
        hardware = self.hardware
        if not isinstance(hardware, BodyHardware) or now_ns <= before_ns:
            return
        hardware.read((now_ns - before_ns) / 1e9)
        for controller in self.controllers.active:
            controller.update((now_ns - before_ns) / 1e9)
        hardware.active_commands = self.controllers.claimed()
        hardware.write()

    def arguments_of(self, name: str) -> list[str]:
        """Return a controller's ROS arguments, with the parameter files of the plugin."""
        words = super().arguments_of(name)
        control = self._robot.model.equipment.control
        shared = [] if control is None else shared_arguments(control)
        # The file of the spawner is later, so its values replace those of the plugin.
        return [*words[:1], *shared, *words[1:]]

    def release(self) -> None:
        """End the manager and its controllers."""
        for name, controller in list(self.controllers.by_name.items()):
            self.controllers.switch([], [name], is_strict=False)
            if self.executor is not None:
                self.executor.remove_node(controller)
            controller.destroy_node()
        if self.executor is not None:
            self.executor.remove_node(self)
        self.destroy_node()


def arguments_of(control: Control) -> list[str]:
    """Return the ROS arguments of the manager of a plugin."""
    words = ["--ros-args", "-r", f"__node:={control.node_name}"]
    if control.namespace:
        words += ["-r", f"__ns:=/{control.namespace.strip('/')}"]
    return [*words, *shared_arguments(control)]


def shared_arguments(control: Control) -> list[str]:
    """Return the ROS arguments that the manager and its controllers share."""
    words = []
    for file in control.files:
        words += ["--params-file", file]
    for before, after in control.remaps:
        words += ["-r", f"{before}:={after}"]
    return [*words, *_SIM_TIME]


def start_control(simulator: Simulator, robot: Robot) -> BodyControl:
    """Start the controller manager of a robot.

    Raises:
        ZbotError: A parameter file or the description cannot be used.
    """
    control = BodyControl(simulator, robot)
    if simulator.executor is not None:
        simulator.executor.add_node(control)
    return control
