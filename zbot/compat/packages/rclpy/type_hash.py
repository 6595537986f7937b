# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `rclpy.type_hash`: every name is zbot's."""

from zbot.compat.annotation import TypeHashDictionary
from zbot.graph.endpoint_info import TypeHash

__all__ = [
    "TypeHash",
    "TypeHashDictionary",
]
