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
