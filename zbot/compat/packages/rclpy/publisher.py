# Written by python -m zbot.compat.generator; do not edit.
"""Publishers."""

from zbot.executor.callback_group import CallbackGroup
from zbot.interfaces.python_class import MsgT, MsgT as MsgType
from zbot.node.event_callbacks import PublisherEventCallbacks
from zbot.node.event_handlers import EventHandler
from zbot.node.publisher import Publisher
from zbot.qos import QoSProfile
from zbot.time import Duration

__all__ = [
    "CallbackGroup",
    "Duration",
    "EventHandler",
    "MsgT",
    "MsgType",
    "Publisher",
    "PublisherEventCallbacks",
    "QoSProfile",
]
