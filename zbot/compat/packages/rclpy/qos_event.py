"""The old name of `rclpy.event_handler`."""

from zbot.compat.annotation import EventHandlerData as EventHandlerData
from zbot.errors import UnsupportedEventTypeError as UnsupportedEventTypeError
from zbot.event import EventHandler as EventHandler
from zbot.event import EventHandler as QoSEventHandler
from zbot.event import IncompatibleTypeInfo as IncompatibleTypeInfo
from zbot.event import PublisherEventCallbacks as PublisherEventCallbacks
from zbot.event import QoSLivelinessChangedInfo as QoSLivelinessChangedInfo
from zbot.event import QoSLivelinessLostInfo as QoSLivelinessLostInfo
from zbot.event import QoSMatchedInfo as QoSPublisherMatchedInfo
from zbot.event import QoSMatchedInfo as QoSSubscriptionMatchedInfo
from zbot.event import QoSMessageLostInfo as QoSMessageLostInfo
from zbot.event import QoSOfferedDeadlineMissedInfo as QoSOfferedDeadlineMissedInfo
from zbot.event import QoSPublisherEventType as QoSPublisherEventType
from zbot.event import QoSRequestedDeadlineMissedInfo as QoSRequestedDeadlineMissedInfo
from zbot.event import QoSRequestedIncompatibleQoSInfo as QoSOfferedIncompatibleQoSInfo
from zbot.event import QoSRequestedIncompatibleQoSInfo as QoSRequestedIncompatibleQoSInfo
from zbot.event import QoSSubscriptionEventType as QoSSubscriptionEventType
from zbot.event import SubscriptionEventCallbacks as SubscriptionEventCallbacks
from zbot.executor.callback_group import CallbackGroup as CallbackGroup
from zbot.executor.waitable import NumberOfEntities as NumberOfEntities
from zbot.executor.waitable import Waitable as Waitable
from zbot.log import get_logger as get_logger
from zbot.qos import qos_policy_name_from_kind as qos_policy_name_from_kind
