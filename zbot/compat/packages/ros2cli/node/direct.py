# Written by python -m zbot.compat.generator; do not edit.
"""The node that queries the graph itself."""

from zbot.compat.command_node import CommandNode as DirectNode, NODE_NAME_PREFIX, add_arguments

__all__ = [
    "DirectNode",
    "NODE_NAME_PREFIX",
    "add_arguments",
]
