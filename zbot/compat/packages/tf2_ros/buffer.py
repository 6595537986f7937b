# Written by python -m zbot.compat.generator; do not edit.
"""The buffer of transforms."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.tf2.buffer import Buffer

__all__ = [
    "Buffer",
    "Duration",
    "FrameGraph",
    "Future",
    "JumpThreshold",
    "Node",
    "Time",
    "TimeJump",
    "TransformStamped",
]

if TYPE_CHECKING:
    from geometry_msgs.msg import TransformStamped as TransformStamped
    from tf2_msgs.srv import FrameGraph as FrameGraph
    from zbot.executor.clock import JumpThreshold as JumpThreshold
    from zbot.executor.clock import TimeJump as TimeJump
    from zbot.executor.task import Future as Future
    from zbot.node.node import Node as Node
    from zbot.time import Duration as Duration
    from zbot.time import Time as Time
else:
    __getattr__ = lazy_names(
        __name__,
        {
            "geometry_msgs.msg": "TransformStamped",
            "tf2_msgs.srv": "FrameGraph",
            "zbot.executor.clock": "JumpThreshold TimeJump",
            "zbot.executor.task": "Future",
            "zbot.node.node": "Node",
            "zbot.time": "Duration Time",
        },
        submodules=(
        ),
    )[0]
