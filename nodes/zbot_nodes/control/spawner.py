"""Load, configure and activate controllers, and exit.

Run:     zbot run controller_manager spawner NAME... [--param-file FILE] [--inactive]
Options: -c NAME of the controller manager, -p FILE with parameters of the controllers (may be
         repeated), -t TYPE, --load-only, --inactive, --activate-as-group,
         --controller-manager-timeout, --switch-timeout, --service-call-timeout,
         --controller-ros-args WORDS; --unload-on-kill is accepted without effect
"""

from __future__ import annotations

import argparse
import sys
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

import zbot
from zbot.parameters.ros_args import remove_ros_args
from zbot_nodes.control.controller import ControllerError

from controller_manager_msgs import srv
from rcl_interfaces.srv import SetParameters

if TYPE_CHECKING:
    from collections.abc import Sequence

_POLL_S = 1.0
_WAIT_LOG_S = 10.0


def read_arguments(words: Sequence[str]) -> argparse.Namespace:
    """Read a command line with the options of ROS 2's spawner."""
    text = "Load, configure and activate controllers"
    parser = argparse.ArgumentParser(prog="spawner", description=text)
    parser.add_argument("controller_names", nargs="+")
    parser.add_argument("-c", "--controller-manager", default="controller_manager")
    parser.add_argument("-p", "--param-file", action="append", default=[])
    parser.add_argument("-t", "--controller-type", default="")
    parser.add_argument("-n", "--namespace", default="")
    parser.add_argument("--load-only", action="store_true")
    parser.add_argument("--inactive", "--stopped", action="store_true")
    parser.add_argument("--activate-as-group", action="store_true")
    parser.add_argument("-u", "--unload-on-kill", action="store_true")
    parser.add_argument("--controller-manager-timeout", type=float, default=0.0)
    parser.add_argument("--switch-timeout", type=float, default=5.0)
    parser.add_argument("--service-call-timeout", type=float, default=10.0)
    parser.add_argument("--switch-asap", action=argparse.BooleanOptionalAction, default=False)
    parser.add_argument("--controller-ros-args", action="append", default=[])
    options = parser.parse_args(remove_ros_args(["spawner", *words])[1:])
    # If a launch file gives `parameters=[file]` to the spawner, the controllers get the parameters.
    files = pairwise(words)
    options.param_file += [path for word, path in files if word == "--params-file"]
    for path in options.param_file:
        if not Path(path).is_file():
            parser.error(f"the file '{path}' of --param-file does not exist")
    return options


class Spawner(zbot.Node):
    """Calls the services of a controller manager."""

    def __init__(self, options: argparse.Namespace, **node_options: Any) -> None:
        name = options.controller_names[0].replace("/", "_").replace(".", "_")
        super().__init__(f"spawner_{name}", **node_options)
        self.options = options
        manager = options.controller_manager
        if not manager.startswith("/"):
            space = options.namespace.strip("/") or self.get_namespace().strip("/")
            manager = f"/{space}/{manager}" if space else f"/{manager}"
        self.manager = manager

    def call(self, type_: Any, service: str, request: Any, timeout_s: float) -> Any:
        """Call a service of the manager.

        Raises:
            ControllerError: There is no answer in time.
        """
        client: Any = self.create_client(type_, f"{self.manager}/{service}")
        self.wait_for(client)
        future = client.call_async(request)
        zbot.spin_until_future_complete(self, future, timeout_sec=timeout_s or None)
        self.destroy_client(client)
        if not future.done():
            raise ControllerError(f"{self.manager}/{service} did not answer in {timeout_s:g} s")
        return future.result()

    def wait_for(self, client: Any) -> None:
        """Wait until the manager has its services, which needs the robot description."""
        limit_s = self.options.controller_manager_timeout
        waited_s = 0.0
        while not client.wait_for_service(_POLL_S):
            waited_s += _POLL_S
            if limit_s and waited_s >= limit_s:
                raise ControllerError(f"{self.manager} was not there in {limit_s:g} s")
            if not waited_s % _WAIT_LOG_S:
                text = f"waiting for service {client.srv_name} to become available..."
                self.get_logger().info(text)

    def ask(self, type_: Any, service: str, failure: str, **fields: Any) -> None:
        """Call a service whose response has `ok`.

        Raises:
            ControllerError: The manager refuses.
        """
        request = type_.Request(**fields)
        response = self.call(type_, service, request, self.options.service_call_timeout)
        if not response.ok:
            reason = getattr(response, "message", "") or "the manager's log has the reason"
            raise ControllerError(f"{failure}: {reason}")

    def spawn(self) -> None:
        """Bring every controller to the wanted state.

        Raises:
            ControllerError: The manager refuses or does not answer.
        """
        options = self.options
        for name in options.controller_names:
            self.load(name)
        if options.load_only:
            return
        for name in options.controller_names:
            self.ask(
                srv.ConfigureController,
                "configure_controller",
                f"Failed to configure {name}",
                name=name,
            )
        if options.inactive:
            return
        together = (
            [options.controller_names]
            if options.activate_as_group
            else [[name] for name in options.controller_names]
        )
        for names in together:
            self.switch(names, [])
            self.get_logger().info(f"Configured and activated {', '.join(names)}")

    def load(self, name: str) -> None:
        """Load a controller, unless it is loaded."""
        listed = self.call(
            srv.ListControllers,
            "list_controllers",
            srv.ListControllers.Request(),
            self.options.service_call_timeout,
        )
        if any(one.name == name for one in listed.controller):
            self.get_logger().warn(f"Controller already loaded, skipping load_controller: {name}")
            return
        self.set_parameters_of(name)
        self.ask(
            srv.LoadController, "load_controller", f"Failed loading controller {name}", name=name
        )
        self.get_logger().info(f"Loaded {name}")

    def set_parameters_of(self, name: str) -> None:
        """Give the manager the type and the files of a controller."""
        values: dict[str, Any] = {}
        if self.options.controller_type:
            values[f"{name}.type"] = self.options.controller_type
        if self.options.param_file:
            paths = [str(Path(path).absolute()) for path in self.options.param_file]
            values[f"{name}.params_file"] = paths
            kind = _type_in(paths, name)
            if kind and f"{name}.type" not in values:
                values[f"{name}.type"] = kind
        if self.options.controller_ros_args:
            values[f"{name}.node_options_args"] = list(self.options.controller_ros_args)
        if not values:
            return
        parameters = [
            zbot.Parameter(key, value=value).to_parameter_msg() for key, value in values.items()
        ]
        request = SetParameters.Request(parameters=parameters)
        timeout_s = self.options.service_call_timeout
        self.call(SetParameters, "set_parameters", request, timeout_s)

    def switch(self, begin: Sequence[str], end: Sequence[str]) -> None:
        """Activate and deactivate controllers."""
        self.ask(
            srv.SwitchController,
            "switch_controller",
            f"Failed to activate controller {', '.join(begin) or ', '.join(end)}",
            activate_controllers=list(begin),
            deactivate_controllers=list(end),
            strictness=srv.SwitchController.Request.STRICT,
            activate_asap=self.options.switch_asap,
        )


def _type_in(paths: Sequence[str], name: str) -> str:
    """Return the type in a controller's own section of a parameter file, or an empty string."""
    from zbot.parameters.file import sections  # noqa: PLC0415 - only for files

    for path in paths:
        for pattern, values in sections(path):
            if pattern.rpartition("/")[2] == name and isinstance(values.get("type"), str):
                return str(values["type"])
    return ""


def main() -> None:
    """Load, configure and activate the controllers."""
    options = read_arguments(sys.argv[1:])
    with zbot.init():
        node = Spawner(options)
        try:
            node.spawn()
        except zbot.ZbotError as error:
            sys.exit(f"error: {error}")


if __name__ == "__main__":
    main()
