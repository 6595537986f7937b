# Written by python -m zbot.compat.generator; do not edit.
"""Managed nodes."""

from zbot.compat.annotation import CallbackNames, CreateLifecyclePublisherArgs, LifecycleNodeArgs
from zbot.executor.callback_group import CallbackGroup
from zbot.interfaces.python_class import MsgT, check_is_valid_srv_type
from zbot.lifecycle import LifecycleState, TransitionCallbackReturn
from zbot.lifecycle.managed_entity import LifecyclePublisher, ManagedEntity
from zbot.lifecycle.node import LifecycleNode, LifecycleNodeMixin
from zbot.log import Logger as RcutilsLogger
from zbot.node.node import Node
from zbot.node.service import Service
from zbot.qos import QoSProfile

__all__ = [
    "CallbackGroup",
    "CallbackNames",
    "CreateLifecyclePublisherArgs",
    "LifecycleNode",
    "LifecycleNodeArgs",
    "LifecycleNodeMixin",
    "LifecyclePublisher",
    "LifecycleState",
    "ManagedEntity",
    "MsgT",
    "Node",
    "QoSProfile",
    "RcutilsLogger",
    "Service",
    "TransitionCallbackReturn",
    "check_is_valid_srv_type",
]
