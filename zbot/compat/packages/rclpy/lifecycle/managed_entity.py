# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `TransitionCallbackReturn` and `ManagedEntity` and `SimpleManagedEntity`."""

from zbot.lifecycle import TransitionCallbackReturn
from zbot.lifecycle.managed_entity import ManagedEntity, SimpleManagedEntity

__all__ = [
    "ManagedEntity",
    "SimpleManagedEntity",
    "TransitionCallbackReturn",
]
