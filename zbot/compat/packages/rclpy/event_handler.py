# Written by python -m zbot.compat.generator; do not edit.
"""Events of quality of service."""

from zbot.compat.annotation import EventHandlerData
from zbot.executor.callback_group import CallbackGroup
from zbot.executor.waitable import NumberOfEntities, Waitable
from zbot.log import get_logger
from zbot.node.errors import UnsupportedEventTypeError
from zbot.node.event_callbacks import PublisherEventCallbacks, SubscriptionEventCallbacks
from zbot.node.event_handlers import EventHandler, EventHandler as QoSEventHandler
from zbot.node.qos_events import (
    IncompatibleTypeInfo,
    QoSLivelinessChangedInfo,
    QoSLivelinessLostInfo,
    QoSMatchedInfo as QoSPublisherMatchedInfo,
    QoSMatchedInfo as QoSSubscriptionMatchedInfo,
    QoSMessageLostInfo,
    QoSOfferedDeadlineMissedInfo,
    QoSPublisherEventType,
    QoSRequestedDeadlineMissedInfo,
    QoSRequestedIncompatibleQoSInfo,
    QoSRequestedIncompatibleQoSInfo as QoSOfferedIncompatibleQoSInfo,
    QoSSubscriptionEventType,
)
from zbot.qos import qos_policy_name_from_kind

__all__ = [
    "CallbackGroup",
    "EventHandler",
    "EventHandlerData",
    "IncompatibleTypeInfo",
    "NumberOfEntities",
    "PublisherEventCallbacks",
    "QoSEventHandler",
    "QoSLivelinessChangedInfo",
    "QoSLivelinessLostInfo",
    "QoSMessageLostInfo",
    "QoSOfferedDeadlineMissedInfo",
    "QoSOfferedIncompatibleQoSInfo",
    "QoSPublisherEventType",
    "QoSPublisherMatchedInfo",
    "QoSRequestedDeadlineMissedInfo",
    "QoSRequestedIncompatibleQoSInfo",
    "QoSSubscriptionEventType",
    "QoSSubscriptionMatchedInfo",
    "SubscriptionEventCallbacks",
    "UnsupportedEventTypeError",
    "Waitable",
    "get_logger",
    "qos_policy_name_from_kind",
]
