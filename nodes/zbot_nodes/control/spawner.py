"""Load, configure and activate controllers, and exit.

Run:     zbot run controller_manager spawner NAME... [--param-file FILE] [--inactive]
         zbot run controller_manager spawner --controller NAME [OPTIONS] --controller NAME [OPTIONS]
Options: -c NAME of the controller manager, -t TYPE, -n NAMESPACE, --activate-as-group,
         --switch-asap, --unload-on-kill, --controller-manager-timeout, --switch-timeout,
         --service-call-timeout; for all controllers, or after `--controller NAME` for this one:
         -p FILE with parameters (may be repeated), --load-only, --inactive,
         --controller-ros-args WORDS
"""

from __future__ import annotations

import argparse
import signal
import sys
import time
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

import zbot
from zbot.libraries import controller_manager
from zbot.parameters.ros_args import remove_ros_args
from zbot_nodes.control.controller import ControllerError

from controller_manager_msgs.srv import SwitchController

if TYPE_CHECKING:
    from collections.abc import Sequence

_EACH = "--controller"  # the option before the name and the options of one controller


def read_arguments(words: Sequence[str]) -> argparse.Namespace:
    """Read a command line with the options of ROS 2's spawner.

    The attribute `controllers` of the result has the options of each controller.
    """
    # Launch files write an empty word for an option that is left out, and for no namespace.
    every = pairwise(remove_ros_args(["spawner", *words]))
    given = [word for before, word in every if word or before in {"-n", "--namespace"}]
    common = _common_parser()
    if _EACH in given:
        options, controllers = _read_each(common, given)
    else:
        common.add_argument("controller_names", nargs="+")
        _add_controller_options(common)
        options = common.parse_args(given)
        controllers = [
            argparse.Namespace(**{**vars(options), "name": name})
            for name in options.controller_names
        ]
    # If a launch file gives `parameters=[file]` to the spawner, the controllers get the parameters.
    files = [path for word, path in pairwise(words) if word == "--params-file"]
    for controller in controllers:
        controller.param_file = [*controller.param_file, *files]
        for path in controller.param_file:
            if not Path(path).is_file():
                common.error(f"the file '{path}' of --param-file does not exist")
    options.controllers = controllers
    return options


def _common_parser() -> argparse.ArgumentParser:
    text = "Load, configure and activate controllers"
    parser = argparse.ArgumentParser(prog="spawner", description=text, allow_abbrev=False)
    parser.add_argument("-c", "--controller-manager", default="controller_manager")
    parser.add_argument("-t", "--controller-type", default="")
    parser.add_argument("-n", "--namespace", default="")
    parser.add_argument("--activate-as-group", action="store_true")
    parser.add_argument("-u", "--unload-on-kill", action="store_true")
    parser.add_argument("--controller-manager-timeout", type=float, default=0.0)
    parser.add_argument("--switch-timeout", type=float, default=5.0)
    parser.add_argument("--service-call-timeout", type=float, default=10.0)
    parser.add_argument("--switch-asap", action=argparse.BooleanOptionalAction, default=False)
    return parser


def _add_controller_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("-p", "--param-file", action="append", default=[])
    parser.add_argument("--load-only", action="store_true")
    parser.add_argument("--inactive", "--stopped", action="store_true")
    parser.add_argument("--controller-ros-args", action="append", default=[])


def _read_each(
    common: argparse.ArgumentParser, words: list[str]
) -> tuple[argparse.Namespace, list[argparse.Namespace]]:
    """Read a command line in which each controller has options of its own."""
    parser = argparse.ArgumentParser(prog="spawner", add_help=False, allow_abbrev=False)
    parser.add_argument("name")
    _add_controller_options(parser)
    starts = [place for place, word in enumerate(words) if word == _EACH]
    others, controllers = words[: starts[0]], []
    for start, end in pairwise([*starts, len(words)]):
        controller, rest = parser.parse_known_args(words[start + 1 : end])
        controllers.append(controller)
        others += rest
    return common.parse_args(others), controllers


class Spawner(zbot.Node):
    """Calls the services of a controller manager."""

    def __init__(self, options: argparse.Namespace, **node_options: Any) -> None:
        name = options.controllers[0].name.replace("/", "_").replace(".", "_")
        super().__init__(f"spawner_{name}", **node_options)
        self.options = options
        self.timeouts = options.controller_manager_timeout, options.service_call_timeout
        self.space = "/" + (options.namespace.strip("/") or self.get_namespace().strip("/"))
        manager = options.controller_manager
        is_absolute = manager.startswith("/")
        self.manager = manager if is_absolute else f"{self.space.rstrip('/')}/{manager}"

    def ask(self, function: Any, failure: str, *arguments: Any) -> None:
        """Call a service whose response has `ok`.

        Raises:
            ControllerError: The manager refuses.
        """
        response = function(self, self.manager, *arguments)
        if not response.ok:
            reason = getattr(response, "message", "") or "the manager's log has the reason"
            raise ControllerError(f"{failure}: {reason}")

    def spawn(self) -> None:
        """Bring every controller to the wanted state.

        Raises:
            ControllerError: The manager refuses.
            ServiceNotFoundError: The manager is not there in time.
            WrongStateError: The manager does not answer.
        """
        wanted = []
        for controller in self.options.controllers:
            self.load(controller)
        for controller in self.options.controllers:
            if controller.load_only:
                continue
            failure = f"Failed to configure {controller.name}"
            self.ask(
                controller_manager.configure_controller, failure, controller.name, *self.timeouts
            )
            wanted += [] if controller.inactive else [controller.name]
        together = [wanted] if self.options.activate_as_group else [[name] for name in wanted]
        for names in filter(None, together):
            self.switch(names, [])
            self.get_logger().info(f"Configured and activated {', '.join(names)}")

    def load(self, controller: argparse.Namespace) -> None:
        """Load a controller, unless it is loaded."""
        loaded = controller_manager.list_controllers(self, self.manager, *self.timeouts).controller
        if any(other.name == controller.name for other in loaded):
            text = f"Controller already loaded, skipping load_controller: {controller.name}"
            self.get_logger().warn(text)
            return
        settings = {
            "type": self.options.controller_type,
            "node_options_args": list(controller.controller_ros_args),
        }
        files = [str(Path(path).absolute()) for path in controller.param_file]
        controller_manager.set_controller_parameters_from_param_files(
            self, self.manager, controller.name, files, self.space
        )
        for key, value in settings.items():
            if value:
                controller_manager.set_controller_parameters(
                    self, self.manager, controller.name, key, value
                )
        failure = f"Failed loading controller {controller.name}"
        self.ask(controller_manager.load_controller, failure, controller.name, *self.timeouts)
        self.get_logger().info(f"Loaded {controller.name}")

    def switch(self, begin: Sequence[str], end: Sequence[str]) -> None:
        """Activate and deactivate controllers."""
        self.ask(
            controller_manager.switch_controllers,
            f"Failed to {'' if begin else 'de'}activate controller {', '.join(begin or end)}",
            end,
            begin,
            SwitchController.Request.STRICT,
            self.options.switch_asap,
            self.options.switch_timeout,
            self.options.service_call_timeout,
        )

    def unload(self, names: Sequence[str]) -> None:
        """Deactivate and remove controllers."""
        self.switch([], names)
        for name in names:
            failure = f"Failed to unload {name}"
            self.ask(controller_manager.unload_controller, failure, name, *self.timeouts)
            self.get_logger().info(f"Unloaded {name}")

    def wait(self) -> None:
        """Wait without end.

        Raises:
            KeyboardInterrupt: The process got SIGINT or SIGTERM.
        """
        self.get_logger().info("Waiting until interrupt to unload controllers")
        while True:
            time.sleep(1.0)  # on Windows, Ctrl-C ends no other wait

    def unload_active(self) -> None:
        """Remove the controllers that were to be activated."""
        active = [
            controller.name
            for controller in self.options.controllers
            if not (controller.inactive or controller.load_only)
        ]
        if active:
            self.unload(active)


def main() -> None:
    """Load, configure and activate the controllers."""
    options = read_arguments(sys.argv[1:])
    handlers = zbot.SignalHandlerOptions.ALL
    if options.unload_on_kill:
        handlers = zbot.SignalHandlerOptions.NO  # the services are called after the signal
        signal.signal(signal.SIGTERM, signal.default_int_handler)
    with zbot.init(signal_handler_options=handlers):
        node = Spawner(options)
        try:
            try:
                node.spawn()
                if options.unload_on_kill:
                    node.wait()
            except KeyboardInterrupt:
                if not options.unload_on_kill:
                    raise
                node.unload_active()
        except zbot.ZbotError as error:
            sys.exit(f"error: {error}")


if __name__ == "__main__":
    main()
