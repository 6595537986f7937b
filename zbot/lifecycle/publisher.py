"""Publisher of a managed node. It publishes only while the node is active."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar

from zbot.lifecycle.managed_entity import SimpleManagedEntity
from zbot.log import get_logger
from zbot.node.publisher import Publisher

if TYPE_CHECKING:
    from zbot.lifecycle.state_machine import LifecycleState, TransitionCallbackReturn

MsgT = TypeVar("MsgT")


class LifecyclePublisher(SimpleManagedEntity, Publisher[MsgT]):
    """Publishes only while its node is active.

    `LifecycleNode.create_lifecycle_publisher` creates such publishers.
    """

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        SimpleManagedEntity.__init__(self)
        Publisher.__init__(self, *args, **kwargs)
        self._has_warned = False

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Publish from now on."""
        self._has_warned = False
        return SimpleManagedEntity.on_activate(self, state)

    def publish(self, msg: MsgT | bytes) -> None:
        """Send a message. While the node is not active, drop each message, and log one warning.

        This method raises the errors of `zbot.Publisher.publish`.
        """
        if self.is_activated:
            Publisher.publish(self, msg)
        elif not self._has_warned:
            self._has_warned = True
            get_logger(self.logger_name).warning(
                f"a message on {self.topic_name} was dropped: the node is not active "
                "(no more warnings come until the node is active)"
            )
