"""Managed nodes."""

from zbot.compat.submodules import submodules
from zbot.lifecycle import LifecycleState as LifecycleState
from zbot.lifecycle import Node as Node
from zbot.lifecycle import NodeMixin as NodeMixin
from zbot.lifecycle import Publisher as Publisher
from zbot.lifecycle import State as State
from zbot.lifecycle import TransitionCallbackReturn as TransitionCallbackReturn
from zbot.lifecycle.managed_entity import ManagedEntity as ManagedEntity
from zbot.lifecycle.managed_entity import SimpleManagedEntity as SimpleManagedEntity
from zbot.lifecycle.node import LifecycleNode as LifecycleNode
from zbot.lifecycle.node import LifecycleNodeMixin as LifecycleNodeMixin
from zbot.lifecycle.publisher import LifecyclePublisher as LifecyclePublisher

__getattr__ = submodules(__name__, "managed_entity", "node", "publisher")
