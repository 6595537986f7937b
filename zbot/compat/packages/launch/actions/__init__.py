# Written by python -m zbot.compat.generator; do not edit.
"""Actions of launch files."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.actions import (
    Action,
    AppendEnvironmentVariable,
    DeclareBooleanLaunchArgument,
    DeclareLaunchArgument,
    EmitEvent,
    ExecuteLocal,
    ExecuteProcess,
    ForEach,
    ForLoop,
    GroupAction,
    IncludeLaunchDescription,
    Log,
    LogDebug,
    LogError,
    LogInfo,
    LogWarning,
    OpaqueCoroutine,
    OpaqueFunction,
    PopEnvironment,
    PopLaunchConfigurations,
    PushEnvironment,
    PushLaunchConfigurations,
    RegisterEventHandler,
    ReplaceEnvironmentVariables,
    ResetEnvironment,
    ResetLaunchConfigurations,
    SetEnvironmentVariable,
    SetLaunchConfiguration,
    Shutdown,
    TimerAction,
    UnregisterEventHandler,
    UnsetEnvironmentVariable,
    UnsetLaunchConfiguration,
)

__all__ = [
    "Action",
    "AppendEnvironmentVariable",
    "DeclareBooleanLaunchArgument",
    "DeclareLaunchArgument",
    "EmitEvent",
    "ExecuteLocal",
    "ExecuteProcess",
    "ForEach",
    "ForLoop",
    "GroupAction",
    "IncludeLaunchDescription",
    "Log",
    "LogDebug",
    "LogError",
    "LogInfo",
    "LogWarning",
    "OpaqueCoroutine",
    "OpaqueFunction",
    "PopEnvironment",
    "PopLaunchConfigurations",
    "PushEnvironment",
    "PushLaunchConfigurations",
    "RegisterEventHandler",
    "ReplaceEnvironmentVariables",
    "ResetEnvironment",
    "ResetLaunchConfigurations",
    "SetEnvironmentVariable",
    "SetLaunchConfiguration",
    "Shutdown",
    "TimerAction",
    "UnregisterEventHandler",
    "UnsetEnvironmentVariable",
    "UnsetLaunchConfiguration",
]

if TYPE_CHECKING:
    from . import append_environment_variable as append_environment_variable
    from . import declare_boolean_launch_argument as declare_boolean_launch_argument
    from . import declare_launch_argument as declare_launch_argument
    from . import emit_event as emit_event
    from . import execute_local as execute_local
    from . import execute_process as execute_process
    from . import for_loop as for_loop
    from . import group_action as group_action
    from . import include_launch_description as include_launch_description
    from . import log as log
    from . import log_debug as log_debug
    from . import log_error as log_error
    from . import log_info as log_info
    from . import log_warning as log_warning
    from . import opaque_coroutine as opaque_coroutine
    from . import opaque_function as opaque_function
    from . import pop_environment as pop_environment
    from . import pop_launch_configurations as pop_launch_configurations
    from . import push_environment as push_environment
    from . import push_launch_configurations as push_launch_configurations
    from . import register_event_handler as register_event_handler
    from . import replace_environment_variables as replace_environment_variables
    from . import reset_environment as reset_environment
    from . import reset_launch_configurations as reset_launch_configurations
    from . import set_environment_variable as set_environment_variable
    from . import set_launch_configuration as set_launch_configuration
    from . import shutdown_action as shutdown_action
    from . import timer_action as timer_action
    from . import unregister_event_handler as unregister_event_handler
    from . import unset_environment_variable as unset_environment_variable
    from . import unset_launch_configuration as unset_launch_configuration
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "append_environment_variable",
            "declare_boolean_launch_argument",
            "declare_launch_argument",
            "emit_event",
            "execute_local",
            "execute_process",
            "for_loop",
            "group_action",
            "include_launch_description",
            "log",
            "log_debug",
            "log_error",
            "log_info",
            "log_warning",
            "opaque_coroutine",
            "opaque_function",
            "pop_environment",
            "pop_launch_configurations",
            "push_environment",
            "push_launch_configurations",
            "register_event_handler",
            "replace_environment_variables",
            "reset_environment",
            "reset_launch_configurations",
            "set_environment_variable",
            "set_launch_configuration",
            "shutdown_action",
            "timer_action",
            "unregister_event_handler",
            "unset_environment_variable",
            "unset_launch_configuration",
        ),
    )[0]
