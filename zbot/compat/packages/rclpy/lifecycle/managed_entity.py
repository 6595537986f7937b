"""Parts of managed nodes."""

from zbot.lifecycle import TransitionCallbackReturn as TransitionCallbackReturn
from zbot.lifecycle.managed_entity import ManagedEntity as ManagedEntity
from zbot.lifecycle.managed_entity import SimpleManagedEntity as SimpleManagedEntity
