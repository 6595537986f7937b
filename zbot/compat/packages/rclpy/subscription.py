"""Subscriptions."""

from zbot.errors import ZbotError as RCLError
from zbot.executor.callback_group import CallbackGroup as CallbackGroup
from zbot.interfaces.type_support import MsgT as MsgT
from zbot.interfaces.type_support import MsgT as MsgType
from zbot.node.content_filter_options import ContentFilterOptions as ContentFilterOptions
from zbot.node.event_callbacks import SubscriptionEventCallbacks as SubscriptionEventCallbacks
from zbot.node.message_info import MessageInfo as MessageInfo
from zbot.node.subscription import Subscription as Subscription
from zbot.qos import QoSProfile as QoSProfile
