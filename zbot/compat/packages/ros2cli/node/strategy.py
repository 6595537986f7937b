# Written by python -m zbot.compat.generator; do not edit.
"""The node that programs should use."""

from zbot.compat.command_node import CommandNode as NodeStrategy, add_arguments

__all__ = [
    "NodeStrategy",
    "add_arguments",
]
