# Written by python -m zbot.compat.generator; do not edit.
"""Nodes, with names that ROS 2's module imports for itself."""

from zbot.launch import Action, LaunchContext
from zbot.launch.actions import ExecuteProcess, Node
from zbot.launch.parameters import Parameter, ParameterFile

__all__ = [
    "Action",
    "ExecuteProcess",
    "LaunchContext",
    "Node",
    "Parameter",
    "ParameterFile",
]
