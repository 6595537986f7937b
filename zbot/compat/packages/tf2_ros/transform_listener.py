# Written by python -m zbot.compat.generator; do not edit.
"""Listeners."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.tf2.broadcaster import (
    TF_STATIC_TOPIC as DEFAULT_STATIC_TF_TOPIC,
    TF_TOPIC as DEFAULT_TF_TOPIC,
)
from zbot.tf2.listener import TransformListener

__all__ = [
    "Buffer",
    "DEFAULT_STATIC_TF_TOPIC",
    "DEFAULT_TF_TOPIC",
    "DurabilityPolicy",
    "HistoryPolicy",
    "Node",
    "QoSProfile",
    "ReentrantCallbackGroup",
    "SingleThreadedExecutor",
    "TFMessage",
    "TransformListener",
]

if TYPE_CHECKING:
    from tf2_msgs.msg import TFMessage as TFMessage
    from zbot.executor.callback_group import ReentrantCallbackGroup as ReentrantCallbackGroup
    from zbot.executor.single_threaded_executor import SingleThreadedExecutor as SingleThreadedExecutor
    from zbot.node.node import Node as Node
    from zbot.qos import DurabilityPolicy as DurabilityPolicy
    from zbot.qos import HistoryPolicy as HistoryPolicy
    from zbot.qos import QoSProfile as QoSProfile
    from zbot.tf2.buffer import Buffer as Buffer
else:
    __getattr__ = lazy_names(
        __name__,
        {
            "tf2_msgs.msg": "TFMessage",
            "zbot.executor.callback_group": "ReentrantCallbackGroup",
            "zbot.executor.single_threaded_executor": "SingleThreadedExecutor",
            "zbot.node.node": "Node",
            "zbot.qos": "DurabilityPolicy HistoryPolicy QoSProfile",
            "zbot.tf2.buffer": "Buffer",
        },
        submodules=(
        ),
    )[0]
