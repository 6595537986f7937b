"""The node that programs are to take."""

from zbot.compat.command_node import CommandNode as NodeStrategy
from zbot.compat.command_node import add_arguments as add_arguments
