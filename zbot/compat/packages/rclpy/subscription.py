# Written by python -m zbot.compat.generator; do not edit.
"""Subscriptions."""

from zbot.errors import ZbotError as RCLError
from zbot.executor.callback_group import CallbackGroup
from zbot.interfaces.python_class import MsgT, MsgT as MsgType
from zbot.node.message_decoder import ContentFilterOptions
from zbot.node.event_callbacks import SubscriptionEventCallbacks
from zbot.node.message_info import MessageInfo
from zbot.node.subscription import Subscription
from zbot.qos import QoSProfile

__all__ = [
    "CallbackGroup",
    "ContentFilterOptions",
    "MessageInfo",
    "MsgT",
    "MsgType",
    "QoSProfile",
    "RCLError",
    "Subscription",
    "SubscriptionEventCallbacks",
]
