"""The node that queries the graph itself."""

from zbot.compat.command_node import NODE_NAME_PREFIX, add_arguments
from zbot.compat.command_node import CommandNode as DirectNode
