# Written by python -m zbot.compat.generator; do not edit.
"""Publishers of managed nodes."""

from zbot.executor.callback_group import CallbackGroup
from zbot.interfaces.python_class import MsgT
from zbot.lifecycle.managed_entity import LifecyclePublisher, SimpleManagedEntity
from zbot.node.event_callbacks import PublisherEventCallbacks
from zbot.node.publisher import Publisher
from zbot.qos import QoSProfile

__all__ = [
    "CallbackGroup",
    "LifecyclePublisher",
    "MsgT",
    "Publisher",
    "PublisherEventCallbacks",
    "QoSProfile",
    "SimpleManagedEntity",
]
