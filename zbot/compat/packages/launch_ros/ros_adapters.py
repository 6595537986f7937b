# Written by python -m zbot.compat.generator; do not edit.
"""The launch's own node, which actions use to communicate with other nodes."""

from zbot.launch.ros_node import (
    LaunchNode as ROSAdapter,
    get_ros_node,
    launch_node as get_ros_adapter,
)

__all__ = [
    "ROSAdapter",
    "get_ros_adapter",
    "get_ros_node",
]
