# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for all names of `ros_gz_bridge.actions`."""

from zbot.launch.actions.gazebo import RosGzBridge

__all__ = [
    "RosGzBridge",
]
