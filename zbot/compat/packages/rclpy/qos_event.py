"""The old name of `rclpy.event_handler`."""

from zbot.compat.annotation import EventHandlerData as EventHandlerData
from zbot.executor.callback_group import CallbackGroup as CallbackGroup
from zbot.executor.waitable import NumberOfEntities as NumberOfEntities
from zbot.executor.waitable import Waitable as Waitable
from zbot.log import get_logger as get_logger
from zbot.node.errors import UnsupportedEventTypeError as UnsupportedEventTypeError
from zbot.node.event_callbacks import PublisherEventCallbacks as PublisherEventCallbacks
from zbot.node.event_callbacks import SubscriptionEventCallbacks as SubscriptionEventCallbacks
from zbot.node.event_handlers import EventHandler as EventHandler
from zbot.node.event_handlers import EventHandler as QoSEventHandler
from zbot.node.qos_events import IncompatibleTypeInfo as IncompatibleTypeInfo
from zbot.node.qos_events import QoSLivelinessChangedInfo as QoSLivelinessChangedInfo
from zbot.node.qos_events import QoSLivelinessLostInfo as QoSLivelinessLostInfo
from zbot.node.qos_events import QoSMatchedInfo as QoSPublisherMatchedInfo
from zbot.node.qos_events import QoSMatchedInfo as QoSSubscriptionMatchedInfo
from zbot.node.qos_events import QoSMessageLostInfo as QoSMessageLostInfo
from zbot.node.qos_events import QoSOfferedDeadlineMissedInfo as QoSOfferedDeadlineMissedInfo
from zbot.node.qos_events import QoSPublisherEventType as QoSPublisherEventType
from zbot.node.qos_events import QoSRequestedDeadlineMissedInfo as QoSRequestedDeadlineMissedInfo
from zbot.node.qos_events import QoSRequestedIncompatibleQoSInfo as QoSOfferedIncompatibleQoSInfo
from zbot.node.qos_events import QoSRequestedIncompatibleQoSInfo as QoSRequestedIncompatibleQoSInfo
from zbot.node.qos_events import QoSSubscriptionEventType as QoSSubscriptionEventType
from zbot.qos import qos_policy_name_from_kind as qos_policy_name_from_kind
