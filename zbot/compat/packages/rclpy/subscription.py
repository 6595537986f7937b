"""Subscriptions."""

from zbot.errors import ZbotError as RCLError
from zbot.event import SubscriptionEventCallbacks as SubscriptionEventCallbacks
from zbot.executor.callback_group import CallbackGroup as CallbackGroup
from zbot.interfaces.type_support import MsgT as MsgT
from zbot.interfaces.type_support import MsgT as MsgType
from zbot.qos import QoSProfile as QoSProfile
from zbot.subscription import ContentFilterOptions as ContentFilterOptions
from zbot.subscription import MessageInfo as MessageInfo
from zbot.subscription import Subscription as Subscription
