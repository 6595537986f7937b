# Written by python -m zbot.compat.generator; do not edit.
"""Handlers that do something when an event happens."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.event_handler import (
    OnActionEventBase,
    OnExecutionComplete,
    OnIncludeLaunchDescription,
    OnProcessExit,
    OnProcessIO,
    OnProcessStart,
    OnShutdown,
)

__all__ = [
    "OnActionEventBase",
    "OnExecutionComplete",
    "OnIncludeLaunchDescription",
    "OnProcessExit",
    "OnProcessIO",
    "OnProcessStart",
    "OnShutdown",
]

if TYPE_CHECKING:
    from . import on_action_event_base as on_action_event_base
    from . import on_execution_complete as on_execution_complete
    from . import on_include_launch_description as on_include_launch_description
    from . import on_process_exit as on_process_exit
    from . import on_process_io as on_process_io
    from . import on_process_start as on_process_start
    from . import on_shutdown as on_shutdown
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "on_action_event_base",
            "on_execution_complete",
            "on_include_launch_description",
            "on_process_exit",
            "on_process_io",
            "on_process_start",
            "on_shutdown",
        ),
    )[0]
