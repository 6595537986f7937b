"""Managed nodes."""

from zbot.compat.submodules import submodules
from zbot.lifecycle import (
    LifecycleState,
    Node,
    NodeMixin,
    Publisher,
    State,
    TransitionCallbackReturn,
)
from zbot.lifecycle.managed_entity import ManagedEntity, SimpleManagedEntity
from zbot.lifecycle.node import LifecycleNode, LifecycleNodeMixin
from zbot.lifecycle.publisher import LifecyclePublisher

__getattr__ = submodules(__name__, "managed_entity", "node", "publisher")
