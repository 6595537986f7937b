"""Publishers."""

from zbot.executor.callback_group import CallbackGroup as CallbackGroup
from zbot.interfaces.type_support import MsgT as MsgT
from zbot.interfaces.type_support import MsgT as MsgType
from zbot.node.event_callbacks import PublisherEventCallbacks as PublisherEventCallbacks
from zbot.node.event_handlers import EventHandler as EventHandler
from zbot.node.publisher import Publisher as Publisher
from zbot.qos import QoSProfile as QoSProfile
from zbot.time import Duration as Duration
