"""What `launch.utilities` has, under its own module's name."""

from zbot.launch.argument_check import is_a as is_a
from zbot.launch.argument_check import is_a_subclass as is_a_subclass
from zbot.launch.argument_check import isclassinstance as isclassinstance
