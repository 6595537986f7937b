"""The functions of a first program, and some more."""

from zbot.context import Context as Context
from zbot.context import get_default_context as get_default_context
from zbot.parameters.ros_args import remove_ros_args as remove_ros_args
from zbot.runtime import get_available_rmw_implementations as get_available_rmw_implementations
from zbot.runtime import get_rmw_implementation_identifier as get_rmw_implementation_identifier
from zbot.runtime import ok as ok
from zbot.runtime import shutdown as shutdown
from zbot.runtime import try_shutdown as try_shutdown
from zbot.time import S_TO_NS as S_TO_NS
from zbot.time import timeout_sec_to_nsec as timeout_sec_to_nsec
