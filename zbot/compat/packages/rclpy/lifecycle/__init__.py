# Written by python -m zbot.compat.generator; do not edit.
"""Managed nodes."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use
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

__all__ = [
    "LifecycleNode",
    "LifecycleNodeMixin",
    "LifecyclePublisher",
    "LifecycleState",
    "ManagedEntity",
    "Node",
    "NodeMixin",
    "Publisher",
    "SimpleManagedEntity",
    "State",
    "TransitionCallbackReturn",
]

if TYPE_CHECKING:
    from . import managed_entity as managed_entity
    from . import node as node
    from . import publisher as publisher
else:
    __getattr__ = at_first_use(
        __name__,
        "managed_entity",
        "node",
        "publisher",
    )
