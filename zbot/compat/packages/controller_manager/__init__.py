# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `controller_manager`: calls of a controller manager."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.libraries.controller_manager import (
    cleanup_controller,
    configure_controller,
    get_parameter_from_param_files,
    list_controller_types,
    list_controllers,
    list_hardware_components,
    list_hardware_interfaces,
    load_controller,
    reload_controller_libraries,
    set_controller_parameters,
    set_controller_parameters_from_param_files,
    set_hardware_component_state,
    switch_controllers,
    unload_controller,
)

__all__ = [
    "cleanup_controller",
    "configure_controller",
    "get_parameter_from_param_files",
    "list_controller_types",
    "list_controllers",
    "list_hardware_components",
    "list_hardware_interfaces",
    "load_controller",
    "reload_controller_libraries",
    "set_controller_parameters",
    "set_controller_parameters_from_param_files",
    "set_hardware_component_state",
    "switch_controllers",
    "unload_controller",
]

if TYPE_CHECKING:
    from . import controller_manager_services as controller_manager_services
    from . import launch_utils as launch_utils
    from . import test_utils as test_utils
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "controller_manager_services",
            "launch_utils",
            "test_utils",
        ),
    )[0]
