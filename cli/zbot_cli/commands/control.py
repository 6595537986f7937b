"""Verbs of `zbot control`: list controllers and hardware, and change their states."""

from __future__ import annotations

from contextlib import contextmanager
from dataclasses import dataclass
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final

import typer

from zbot.interfaces.plain_value import json_value
from zbot.libraries import controller_manager
from zbot_cli.domain.client import hidden_node, note_if_nobody_runs
from zbot_cli.errors import CommandError
from zbot_cli.input.many_values import ManyValuesCommand
from zbot_cli.input.option_groups import with_option_groups
from zbot_cli.output.listing import AsJson, DaemonOptions, new_app, print_json

from controller_manager_msgs.srv import SwitchController
from lifecycle_msgs.msg import State

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Sequence

    from zbot.node.node import Node

app = new_app("Look at controllers and change their states")

ControllerName = Annotated[str, typer.Argument(help="Name of the controller")]
#: States of a controller, also by the words of ROS 2 Humble and Galactic.
_STATES = {
    "unconfigured": "unconfigured",
    "inactive": "inactive",
    "configured": "inactive",
    "configure": "inactive",
    "stop": "inactive",
    "active": "active",
    "start": "active",
}


class ComponentState(str, Enum):
    """State of a hardware component."""

    UNCONFIGURED = "unconfigured"
    INACTIVE = "inactive"
    ACTIVE = "active"


@dataclass(frozen=True)
class ManagerOptions(DaemonOptions):
    """Group of options that say which controller manager a verb asks."""

    manager: Annotated[
        str, typer.Option("-c", "--controller-manager", help="Name of the controller manager")
    ] = "/controller_manager"
    include_hidden: Annotated[
        bool, typer.Option("--include-hidden-nodes", hidden=True, help="Accepted; no effect")
    ] = False


_USUAL: Final = ManagerOptions()


class SwitchCommand(ManyValuesCommand):
    """Parser of options that take several controllers."""

    many: ClassVar[frozenset[str]] = frozenset({"--activate", "--start", "--deactivate", "--stop"})


class Manager:
    """Client of a controller manager.

    Args:
        node: The node of the command.
        name: The name of the manager.
    """

    def __init__(self, node: Node, name: str) -> None:
        self._node, self.name = node, name

    def ask(self, function: Callable[..., Any], *arguments: Any) -> Any:
        """Return the response of one of the manager's services."""
        return function(self._node, self.name, *arguments)

    def change(self, failure: str, function: Callable[..., Any], *arguments: Any) -> None:
        """Call a service whose response has `ok`.

        Raises:
            CommandError: The manager refuses.
        """
        response = self.ask(function, *arguments)
        if not response.ok:
            reason = getattr(response, "message", "") or "the manager's log has the reason"
            raise CommandError(f"{failure}: {reason}")

    def load(self, name: str, files: list[Path]) -> None:
        """Load a controller with the parameters of files."""
        set_parameters = controller_manager.set_controller_parameters_from_param_files
        paths = [str(path.absolute()) for path in files]
        if not self.ask(set_parameters, name, paths, self.name.rpartition("/")[0]):
            raise CommandError(f"the manager refuses the parameters of {name}")
        self.change(f"cannot load {name}", controller_manager.load_controller, name)

    def configure(self, name: str) -> None:
        """Let a controller read its parameters."""
        self.change(f"cannot configure {name}", controller_manager.configure_controller, name)

    def clean_up(self, name: str) -> None:
        """Undo the configuration of a controller."""
        self.change(f"cannot clean up {name}", controller_manager.cleanup_controller, name)

    def set_state(self, name: str, wanted: str) -> None:
        """Change the state of a controller that is loaded.

        Raises:
            CommandError: There is no such controller, or a state between is missing.
        """
        found = self.ask(controller_manager.list_controllers).controller
        states = {each.name: each.state for each in found}
        if name not in states:
            known = ", ".join(states) or "none"
            raise CommandError(f"no controller {name} is loaded", hint=f"loaded are: {known}")
        match states[name], wanted:
            case ("inactive", "active"):
                self.switch([name], [])
            case ("active", "inactive"):
                self.switch([], [name])
            case ("unconfigured", "inactive"):
                self.configure(name)
            case ("inactive", "unconfigured"):
                self.clean_up(name)
            case (present, _) if present != wanted:
                raise CommandError(f"{name} is {present}: set it to inactive first")

    def switch(
        self,
        activated: list[str],
        deactivated: list[str],
        *,
        is_strict: bool = True,
        activate_asap: bool = False,
        timeout_s: float = 5.0,
    ) -> None:
        """Activate and deactivate controllers."""
        kind = SwitchController.Request
        strictness = kind.STRICT if is_strict else kind.BEST_EFFORT
        self.change(
            "cannot switch controllers",
            controller_manager.switch_controllers,
            deactivated,
            activated,
            strictness,
            activate_asap,
            timeout_s,
        )


@contextmanager
def _connected(options: ManagerOptions) -> Iterator[Manager]:
    """Yield a client of the manager. Its first call waits for the manager, as in ROS 2."""
    with hidden_node("control") as node:
        note_if_nobody_runs(node.context.graph.snapshot())
        yield Manager(node, options.manager)


@app.command("list_controllers")
@with_option_groups
def list_controllers(
    claimed: Annotated[
        bool, typer.Option("--claimed-interfaces", help="Add the interfaces that it uses now")
    ] = False,
    verbose: Annotated[
        bool, typer.Option("-v", "--verbose", help="Add the interfaces that it needs too")
    ] = False,
    as_json: AsJson = False,
    options: ManagerOptions = _USUAL,
) -> None:
    """List controllers, their types and states."""
    with _connected(options) as manager:
        found = manager.ask(controller_manager.list_controllers).controller
    if as_json:
        print_json(json_value(found))
        return
    lines = _table([(each.name, each.type, each.state) for each in found])
    for line, each in zip(lines, found, strict=True):
        print(line)
        if claimed or verbose:
            _print_names("claimed interfaces", each.claimed_interfaces)
        if verbose:
            _print_names("required command interfaces", each.required_command_interfaces)
            _print_names("required state interfaces", each.required_state_interfaces)


@app.command("list_controller_types")
@with_option_groups
def list_controller_types(as_json: AsJson = False, options: ManagerOptions = _USUAL) -> None:
    """List the types of controllers."""
    with _connected(options) as manager:
        found = manager.ask(controller_manager.list_controller_types)
    types = list(zip(found.types, found.base_classes, strict=True))
    if as_json:
        print_json([{"type": kind, "base_class": base} for kind, base in types])
        return
    print(*_table(types), sep="\n")


@app.command("list_hardware_components")
@with_option_groups
def list_hardware_components(
    verbose: Annotated[
        bool, typer.Option("-v", "--verbose", help="Add the states to read")
    ] = False,
    as_json: AsJson = False,
    options: ManagerOptions = _USUAL,
) -> None:
    """List the hardware components with their states."""
    with _connected(options) as manager:
        found = manager.ask(controller_manager.list_hardware_components).component
    if as_json:
        print_json(json_value(found))
        return
    for number, each in enumerate(found, 1):
        print(f"Hardware Component {number}\n\tname: {each.name}\n\ttype: {each.type}")
        print(f"\tplugin name: {each.plugin_name}")
        print(f"\tstate: id={each.state.id} label={each.state.label}")
        _print_names("command interfaces", map(_command_interface, each.command_interfaces))
        if verbose:
            _print_names("state interfaces", map(_state_interface, each.state_interfaces))


@app.command("list_hardware_interfaces")
@with_option_groups
def list_hardware_interfaces(as_json: AsJson = False, options: ManagerOptions = _USUAL) -> None:
    """List the interfaces of the hardware."""
    with _connected(options) as manager:
        found = manager.ask(controller_manager.list_hardware_interfaces)
    if as_json:
        print_json(json_value(found))
        return
    print("command interfaces")
    for each in found.command_interfaces:
        print(f"\t{_command_interface(each)}")
    print("state interfaces")
    for each in found.state_interfaces:
        print(f"\t{_state_interface(each)}")


@app.command("load_controller")
@with_option_groups
def load_controller(
    name: ControllerName,
    param_file: Annotated[
        list[Path] | None,
        typer.Argument(metavar="[FILE]...", exists=True, help="YAML files with its parameters"),
    ] = None,
    set_state: Annotated[
        str, typer.Option("--set-state", metavar="STATE", help="Then: inactive or active")
    ] = "",
    options: ManagerOptions = _USUAL,
) -> None:
    """Load a controller, and start it if wanted."""
    state = _state(set_state) if set_state else "unconfigured"
    with _connected(options) as manager:
        manager.load(name, param_file or [])
        if state != "unconfigured":
            manager.configure(name)
        if state == "active":
            manager.switch([name], [])
    into = f" into state {state}" if set_state else ""
    print(f"Successfully loaded controller {name}{into}")


@app.command("unload_controller")
@with_option_groups
def unload_controller(name: ControllerName, options: ManagerOptions = _USUAL) -> None:
    """Remove a controller that is not active."""
    with _connected(options) as manager:
        unload = controller_manager.unload_controller
        manager.change(f"cannot unload {name}", unload, name)
    print(f"Successfully unloaded controller {name}")


@app.command("cleanup_controller")
@with_option_groups
def cleanup_controller(name: ControllerName, options: ManagerOptions = _USUAL) -> None:
    """Undo the configuration of a controller."""
    with _connected(options) as manager:
        manager.clean_up(name)
    print(f"Successfully cleaned up controller {name}")


@app.command("set_controller_state")
@with_option_groups
def set_controller_state(
    name: ControllerName,
    state: Annotated[str, typer.Argument(help="unconfigured, inactive or active")],
    options: ManagerOptions = _USUAL,
) -> None:
    """Change the state of a controller."""
    wanted = _state(state)
    with _connected(options) as manager:
        manager.set_state(name, wanted)
    print(f"Successfully set {name} to {wanted}")


@app.command("switch_controllers", cls=SwitchCommand)
@with_option_groups
def switch_controllers(
    activate: Annotated[
        list[str] | None, typer.Option("--activate", "--start", help="Controllers to activate")
    ] = None,
    deactivate: Annotated[
        list[str] | None, typer.Option("--deactivate", "--stop", help="Controllers to deactivate")
    ] = None,
    strict: Annotated[
        bool, typer.Option("--strict", help="If one of them fails, change nothing")
    ] = False,
    activate_asap: Annotated[
        bool,
        typer.Option("--activate-asap", "--start-asap", help="Activate as soon as possible"),
    ] = False,
    switch_timeout: Annotated[
        float, typer.Option("--switch-timeout", min=0, help="Seconds until it has failed")
    ] = 5.0,
    options: ManagerOptions = _USUAL,
) -> None:
    """Activate and deactivate controllers together."""
    with _connected(options) as manager:
        manager.switch(
            activate or [],
            deactivate or [],
            is_strict=strict,
            activate_asap=activate_asap,
            timeout_s=switch_timeout,
        )
    print("Successfully switched controllers")


@app.command("set_hardware_component_state")
@with_option_groups
def set_hardware_component_state(
    name: Annotated[str, typer.Argument(help="Name of the hardware component")],
    state: Annotated[ComponentState, typer.Argument(help="State to set")],
    options: ManagerOptions = _USUAL,
) -> None:
    """Change the state of a hardware component."""
    with _connected(options) as manager:
        manager.change(
            f"cannot set {name} to {state.value}",
            controller_manager.set_hardware_component_state,
            name,
            State(label=state.value),
        )
    print(f"Successfully set {name} to {state.value}")


def _state(text: str) -> str:
    if text not in _STATES:
        raise typer.BadParameter(f"a controller has no state '{text}': write inactive or active")
    return _STATES[text]


def _table(rows: Sequence[tuple[str, ...]]) -> list[str]:
    """Return the lines of rows whose columns begin below each other."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return ["  ".join(map(str.ljust, row, widths)).rstrip() for row in rows]


def _print_names(title: str, names: Iterable[str]) -> None:
    print(f"\t{title}", *(f"\t\t{name}" for name in names), sep="\n")


def _command_interface(interface: Any) -> str:
    claimed = "claimed" if interface.is_claimed else "unclaimed"
    return f"{_state_interface(interface)} [{claimed}]"


def _state_interface(interface: Any) -> str:
    available = "available" if interface.is_available else "unavailable"
    return f"{interface.name} [{available}]"
