"""The node that programs should use."""

from zbot.compat.command_node import CommandNode as NodeStrategy
from zbot.compat.command_node import add_arguments
