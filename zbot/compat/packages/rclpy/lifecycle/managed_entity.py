"""Parts of managed nodes."""

from zbot.lifecycle import TransitionCallbackReturn
from zbot.lifecycle.managed_entity import ManagedEntity, SimpleManagedEntity
