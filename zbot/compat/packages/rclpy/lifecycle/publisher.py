"""Publishers of managed nodes."""

from zbot.executor.callback_group import CallbackGroup as CallbackGroup
from zbot.interfaces.type_support import MsgT as MsgT
from zbot.lifecycle.managed_entity import SimpleManagedEntity as SimpleManagedEntity
from zbot.lifecycle.publisher import LifecyclePublisher as LifecyclePublisher
from zbot.node.event_callbacks import PublisherEventCallbacks as PublisherEventCallbacks
from zbot.node.publisher import Publisher as Publisher
from zbot.qos import QoSProfile as QoSProfile
