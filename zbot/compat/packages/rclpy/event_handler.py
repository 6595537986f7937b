"""Events of quality of service."""

from zbot.compat.annotation import EventHandlerData
from zbot.executor.callback_group import CallbackGroup
from zbot.executor.waitable import NumberOfEntities, Waitable
from zbot.log import get_logger
from zbot.node.errors import UnsupportedEventTypeError
from zbot.node.event_callbacks import PublisherEventCallbacks, SubscriptionEventCallbacks
from zbot.node.event_handlers import EventHandler
from zbot.node.event_handlers import EventHandler as QoSEventHandler
from zbot.node.qos_events import (
    IncompatibleTypeInfo,
    QoSLivelinessChangedInfo,
    QoSLivelinessLostInfo,
    QoSMessageLostInfo,
    QoSOfferedDeadlineMissedInfo,
    QoSPublisherEventType,
    QoSRequestedDeadlineMissedInfo,
    QoSRequestedIncompatibleQoSInfo,
    QoSSubscriptionEventType,
)
from zbot.node.qos_events import QoSMatchedInfo as QoSPublisherMatchedInfo
from zbot.node.qos_events import QoSMatchedInfo as QoSSubscriptionMatchedInfo
from zbot.node.qos_events import QoSRequestedIncompatibleQoSInfo as QoSOfferedIncompatibleQoSInfo
from zbot.qos import qos_policy_name_from_kind
