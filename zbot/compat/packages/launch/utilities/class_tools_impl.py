"""Names of `launch.utilities` under the name of their own module."""

from zbot.launch.argument_check import is_a, is_a_subclass, isclassinstance
