# Written by python -m zbot.compat.generator; do not edit.
"""A buffer of another node."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.tf2.remote_buffer import BufferClient

__all__ = [
    "ActionClient",
    "BufferClient",
    "Clock",
    "Duration",
    "LookupTransform",
    "Node",
    "Time",
    "TransformStamped",
]

if TYPE_CHECKING:
    from geometry_msgs.msg import TransformStamped as TransformStamped
    from tf2_msgs.action import LookupTransform as LookupTransform
    from zbot.action.client import ActionClient as ActionClient
    from zbot.executor.clock import Clock as Clock
    from zbot.node.node import Node as Node
    from zbot.time import Duration as Duration
    from zbot.time import Time as Time
else:
    __getattr__ = lazy_names(
        __name__,
        {
            "geometry_msgs.msg": "TransformStamped",
            "tf2_msgs.action": "LookupTransform",
            "zbot.action.client": "ActionClient",
            "zbot.executor.clock": "Clock",
            "zbot.node.node": "Node",
            "zbot.time": "Duration Time",
        },
        submodules=(
        ),
    )[0]
