"""What `launch.utilities` has, under its own module's name."""

from zbot.launch.argument_check import ensure_argument_type as ensure_argument_type
