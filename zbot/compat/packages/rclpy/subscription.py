"""Subscriptions."""

from zbot.callback_group import CallbackGroup as CallbackGroup
from zbot.event import SubscriptionEventCallbacks as SubscriptionEventCallbacks
from zbot.qos import QoSProfile as QoSProfile
from zbot.subscription import MessageInfo as MessageInfo
from zbot.subscription import Subscription as Subscription
