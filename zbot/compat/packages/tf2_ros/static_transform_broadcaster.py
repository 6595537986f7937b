# Written by python -m zbot.compat.generator; do not edit.
"""Broadcaster of transforms that do not change."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.tf2.broadcaster import StaticTransformBroadcaster

__all__ = [
    "DurabilityPolicy",
    "HistoryPolicy",
    "Node",
    "QoSProfile",
    "StaticTransformBroadcaster",
    "TFMessage",
    "TransformStamped",
]

if TYPE_CHECKING:
    from geometry_msgs.msg import TransformStamped as TransformStamped
    from tf2_msgs.msg import TFMessage as TFMessage
    from zbot.node.node import Node as Node
    from zbot.qos import DurabilityPolicy as DurabilityPolicy
    from zbot.qos import HistoryPolicy as HistoryPolicy
    from zbot.qos import QoSProfile as QoSProfile
else:
    __getattr__ = lazy_names(
        __name__,
        {
            "geometry_msgs.msg": "TransformStamped",
            "tf2_msgs.msg": "TFMessage",
            "zbot.node.node": "Node",
            "zbot.qos": "DurabilityPolicy HistoryPolicy QoSProfile",
        },
        submodules=(
        ),
    )[0]
