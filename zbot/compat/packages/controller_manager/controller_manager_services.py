# Written by python -m zbot.compat.generator; do not edit.
"""The same names, the function that they call, and its errors."""

from zbot.libraries.controller_manager import (
    ServiceNotFoundError,
    cleanup_controller,
    configure_controller,
    get_parameter_from_param_files,
    list_controller_types,
    list_controllers,
    list_hardware_components,
    list_hardware_interfaces,
    load_controller,
    reload_controller_libraries,
    service_caller,
    set_controller_parameters,
    set_controller_parameters_from_param_files,
    set_hardware_component_state,
    switch_controllers,
    unload_controller,
)

__all__ = [
    "ServiceNotFoundError",
    "cleanup_controller",
    "configure_controller",
    "get_parameter_from_param_files",
    "list_controller_types",
    "list_controllers",
    "list_hardware_components",
    "list_hardware_interfaces",
    "load_controller",
    "reload_controller_libraries",
    "service_caller",
    "set_controller_parameters",
    "set_controller_parameters_from_param_files",
    "set_hardware_component_state",
    "switch_controllers",
    "unload_controller",
]
