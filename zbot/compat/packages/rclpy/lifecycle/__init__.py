# Written by python -m zbot.compat.generator; do not edit.
"""Managed nodes."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.lifecycle import (
    LifecycleState,
    Node,
    NodeMixin,
    Publisher,
    State,
    TransitionCallbackReturn,
)
from zbot.lifecycle.managed_entity import LifecyclePublisher, ManagedEntity, SimpleManagedEntity
from zbot.lifecycle.node import LifecycleNode, LifecycleNodeMixin

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
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "managed_entity",
            "node",
            "publisher",
        ),
    )[0]
