# Written by python -m zbot.compat.generator; do not edit.
"""Functions of the default context, and some others."""

from zbot.context import Context, get_default_context
from zbot.parameters.ros_args import remove_ros_args
from zbot.runtime import (
    get_available_rmw_implementations,
    get_rmw_implementation_identifier,
    ok,
    shutdown,
    try_shutdown,
)
from zbot.time import S_TO_NS, timeout_sec_to_nsec

__all__ = [
    "Context",
    "S_TO_NS",
    "get_available_rmw_implementations",
    "get_default_context",
    "get_rmw_implementation_identifier",
    "ok",
    "remove_ros_args",
    "shutdown",
    "timeout_sec_to_nsec",
    "try_shutdown",
]
