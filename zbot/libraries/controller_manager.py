"""Calls of a controller manager's services, with the functions of ROS 2's `controller_manager`.

In all functions, `controller_manager_name` is the name of the manager's node. A relative name is in
the namespace of the calling node. `service_timeout` is how long to wait for the manager in seconds
(0: for ever), and `call_timeout` is how long to wait for the response. The functions return the
response of the service. No other thread may spin the node.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from zbot.errors import WrongStateError, ZbotError
from zbot.parameters.file import matches, sections
from zbot.parameters.parameter import Parameter
from zbot.runtime import spin_until_future_complete
from zbot.time import Duration

from controller_manager_msgs import srv
from rcl_interfaces.srv import SetParameters

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.node.node import Node

    from lifecycle_msgs.msg import State

_WAIT_LOG_S = 10.0


class ServiceNotFoundError(ZbotError):
    """A controller manager was not there in time."""


def service_caller(
    node: Node,
    service_name: str,
    service_type: Any,
    request: Any,
    service_timeout: float = 0.0,
    call_timeout: float = 10.0,
    max_attempts: int = 3,
) -> Any:
    """Wait for a service, call it, and return the response.

    Raises:
        ServiceNotFoundError: The service was not there in time.
        WrongStateError: No response came, also after `max_attempts` calls.
    """
    space = node.get_namespace().rstrip("/")
    name = service_name if service_name.startswith("/") else f"{space}/{service_name}"
    client = node.create_client(service_type, name)
    try:
        while not client.wait_for_service(service_timeout or _WAIT_LOG_S):
            if service_timeout:
                raise ServiceNotFoundError(
                    f"Could not contact service {name} in {service_timeout:g} s"
                )
            node.get_logger().info(f"waiting for service {name} to become available...")
        for attempt in range(1, max_attempts + 1):
            future = client.call_async(request)
            spin_until_future_complete(node, future, timeout_sec=call_timeout or None)
            if future.done():
                return future.result()
            node.get_logger().warning(
                f"{name} did not answer in {call_timeout:g} s (attempt {attempt} of {max_attempts})"
            )
    finally:
        node.destroy_client(client)
    raise WrongStateError(f"{name} did not answer {max_attempts} calls of {call_timeout:g} s")


def _call(
    node: Node, manager: str, kind: Any, service_timeout: float, call_timeout: float, **fields: Any
) -> Any:
    name = re.sub(
        "(?<!^)(?=[A-Z])", "_", kind.__name__
    ).lower()  # ListControllers: list_controllers
    request = kind.Request(**fields)
    return service_caller(node, f"{manager}/{name}", kind, request, service_timeout, call_timeout)


def list_controllers(
    node: Node,
    controller_manager_name: str,
    service_timeout: float = 0.0,
    call_timeout: float = 10.0,
) -> Any:
    """Return the controllers that are loaded, with their types and states."""
    return _call(node, controller_manager_name, srv.ListControllers, service_timeout, call_timeout)


def list_controller_types(
    node: Node,
    controller_manager_name: str,
    service_timeout: float = 0.0,
    call_timeout: float = 10.0,
) -> Any:
    """Return the types of controllers that the manager can load."""
    return _call(
        node, controller_manager_name, srv.ListControllerTypes, service_timeout, call_timeout
    )


def list_hardware_components(
    node: Node,
    controller_manager_name: str,
    service_timeout: float = 0.0,
    call_timeout: float = 10.0,
) -> Any:
    """Return the hardware of the robot description."""
    return _call(
        node, controller_manager_name, srv.ListHardwareComponents, service_timeout, call_timeout
    )


def list_hardware_interfaces(
    node: Node,
    controller_manager_name: str,
    service_timeout: float = 0.0,
    call_timeout: float = 10.0,
) -> Any:
    """Return the command interfaces and the state interfaces of the hardware."""
    return _call(
        node, controller_manager_name, srv.ListHardwareInterfaces, service_timeout, call_timeout
    )


def load_controller(
    node: Node,
    controller_manager_name: str,
    controller_name: str,
    service_timeout: float = 0.0,
    call_timeout: float = 10.0,
) -> Any:
    """Load a controller whose type the manager knows."""
    return _call(
        node,
        controller_manager_name,
        srv.LoadController,
        service_timeout,
        call_timeout,
        name=controller_name,
    )


def configure_controller(
    node: Node,
    controller_manager_name: str,
    controller_name: str,
    service_timeout: float = 0.0,
    call_timeout: float = 10.0,
) -> Any:
    """Let a controller read its parameters."""
    return _call(
        node,
        controller_manager_name,
        srv.ConfigureController,
        service_timeout,
        call_timeout,
        name=controller_name,
    )


def cleanup_controller(
    node: Node,
    controller_manager_name: str,
    controller_name: str,
    service_timeout: float = 0.0,
    call_timeout: float = 10.0,
) -> Any:
    """Undo the configuration of a controller."""
    return _call(
        node,
        controller_manager_name,
        srv.CleanupController,
        service_timeout,
        call_timeout,
        name=controller_name,
    )


def unload_controller(
    node: Node,
    controller_manager_name: str,
    controller_name: str,
    service_timeout: float = 0.0,
    call_timeout: float = 10.0,
) -> Any:
    """Remove a controller that is not active."""
    return _call(
        node,
        controller_manager_name,
        srv.UnloadController,
        service_timeout,
        call_timeout,
        name=controller_name,
    )


def reload_controller_libraries(
    node: Node,
    controller_manager_name: str,
    force_kill: bool,
    service_timeout: float = 0.0,
    call_timeout: float = 10.0,
) -> Any:
    """Load the plugins of a manager of ROS 2 again. zbot's manager has no such service."""
    return _call(
        node,
        controller_manager_name,
        srv.ReloadControllerLibraries,
        service_timeout,
        call_timeout,
        force_kill=force_kill,
    )


def set_hardware_component_state(
    node: Node,
    controller_manager_name: str,
    component_name: str,
    lifecyle_state: State,
    service_timeout: float = 0.0,
    call_timeout: float = 10.0,
) -> Any:
    """Change the state of a hardware component."""
    return _call(
        node,
        controller_manager_name,
        srv.SetHardwareComponentState,
        service_timeout,
        call_timeout,
        name=component_name,
        target_state=lifecyle_state,
    )


def switch_controllers(
    node: Node,
    controller_manager_name: str,
    deactivate_controllers: Sequence[str],
    activate_controllers: Sequence[str],
    strictness: int,
    activate_asap: bool,
    timeout: float,
    call_timeout: float = 10.0,
) -> Any:
    """Deactivate and activate controllers within `timeout` seconds.

    `strictness` is a constant of `SwitchController.Request`, e.g. `STRICT`.
    """
    return _call(
        node,
        controller_manager_name,
        srv.SwitchController,
        0.0,
        call_timeout,
        activate_controllers=list(activate_controllers),
        deactivate_controllers=list(deactivate_controllers),
        strictness=strictness,
        activate_asap=activate_asap,
        timeout=Duration(seconds=timeout).to_msg(),
    )


def get_parameter_from_param_files(
    node: Node,  # noqa: ARG001 - the signature of ROS 2
    controller_name: str,
    namespace: str,
    parameter_files: Sequence[str],
    parameter_name: str,
) -> Any:
    """Return the first value that parameter files have for a controller, or None.

    Raises:
        ParametersFileError: A file cannot be read, or does not have ROS 2's format.
    """
    for path in parameter_files:
        values = _parameters(str(path), controller_name, namespace)
        if parameter_name in values:
            return values[parameter_name]
    return None


def _parameters(path: str, controller: str, namespace: str) -> dict[str, Any]:
    """Return what a file has for a controller. The namespace may be missing in the file."""
    full = f"{namespace.rstrip('/')}/{controller}"
    found: dict[str, Any] = {}
    for pattern, values in sections(path):
        if matches(pattern, full) or pattern.strip("/") == controller:
            found.update(values)
    return found


def set_controller_parameters(
    node: Node,
    controller_manager_name: str,
    controller_name: str,
    parameter_name: str,
    parameter_value: Any,
) -> bool:
    """Give the manager a parameter of a controller. Return whether the manager accepted it."""
    parameter = Parameter(f"{controller_name}.{parameter_name}", value=parameter_value)
    request = SetParameters.Request(parameters=[parameter.to_parameter_msg()])
    name = f"{controller_manager_name}/set_parameters"
    (result,) = service_caller(node, name, SetParameters, request).results
    text = f'controller param "{parameter_name}" to "{parameter_value}" for {controller_name}'
    if result.successful:
        node.get_logger().info(f"Setting {text}")
    else:
        node.get_logger().fatal(f"Could not set {text}: {result.reason}")
    return bool(result.successful)


def set_controller_parameters_from_param_files(
    node: Node,
    controller_manager_name: str,
    controller_name: str,
    parameter_files: Sequence[str],
    namespace: str | None = None,
) -> bool:
    """Give the manager the type of a controller, and the files that have parameters for it.

    Return whether the manager accepted them.

    Raises:
        ParametersFileError: A file cannot be read, or does not have ROS 2's format.
    """
    space = namespace or node.get_namespace()
    files = [
        str(path) for path in parameter_files if _parameters(str(path), controller_name, space)
    ]
    if not files:
        return True
    settings = {"params_file": files}
    for name in ("type", "fallback_controllers"):
        value = get_parameter_from_param_files(node, controller_name, space, files, name)
        if value:
            settings[name] = value
    return all(
        set_controller_parameters(node, controller_manager_name, controller_name, name, value)
        for name, value in settings.items()
    )
