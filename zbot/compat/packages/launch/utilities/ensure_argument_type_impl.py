"""Names of `launch.utilities` under the name of their own module."""

from zbot.launch.argument_check import ensure_argument_type
