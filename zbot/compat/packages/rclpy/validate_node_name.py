# Written by python -m zbot.compat.generator; do not edit.
"""Checks of nodes' names."""

from zbot.errors import InvalidNodeNameError as InvalidNodeNameException
from zbot.names import validate_node_name

__all__ = [
    "InvalidNodeNameException",
    "validate_node_name",
]
