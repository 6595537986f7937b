"""The node that asks by itself."""

from zbot.compat.command_node import NODE_NAME_PREFIX as NODE_NAME_PREFIX
from zbot.compat.command_node import CommandNode as DirectNode
from zbot.compat.command_node import add_arguments as add_arguments
