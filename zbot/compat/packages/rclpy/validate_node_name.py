"""Checks of nodes' names."""

from zbot.errors import InvalidNodeNameError as InvalidNodeNameException
from zbot.names import validate_node_name
