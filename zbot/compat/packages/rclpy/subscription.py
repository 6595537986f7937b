"""Subscriptions."""

from zbot.errors import ZbotError as RCLError
from zbot.executor.callback_group import CallbackGroup
from zbot.interfaces.type_support import MsgT
from zbot.interfaces.type_support import MsgT as MsgType
from zbot.node.content_filter_options import ContentFilterOptions
from zbot.node.event_callbacks import SubscriptionEventCallbacks
from zbot.node.message_info import MessageInfo
from zbot.node.subscription import Subscription
from zbot.qos import QoSProfile
