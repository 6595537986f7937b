"""Timer that publishes a message at a rate."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.timer import Timer
    from zbot.node.node import Node
    from zbot.node.publisher import Publisher
    from zbot.observer.shared_entities import EntityReference


class RepeatedPublishing:
    """Timer that publishes at a rate, in the node's thread, until `release`.

    Args:
        node: The node of the timer.
        reference: A reference to the publisher, which `release` releases too.
        make: Function that returns the message. It is called for each message, so that
            each message has a new stamp.
        rate_hz: Messages a second.
    """

    def __init__(
        self,
        node: Node,
        reference: EntityReference[Publisher[Any]],
        make: Callable[[], Any],
        rate_hz: float,
    ) -> None:
        self._node, self._reference = node, reference
        self._make, self._rate_hz = make, rate_hz
        self._timer: Timer | None = node.create_timer(1 / rate_hz, self._publish)
        self._publish()

    def change(self, make: Callable[[], Any], rate_hz: float) -> None:
        """Change the message or the rate."""
        self._make = make
        if rate_hz != self._rate_hz and self._timer is not None:
            self._rate_hz = rate_hz
            self._node.destroy_timer(self._timer)
            self._timer = self._node.create_timer(1 / rate_hz, self._publish)

    def _publish(self) -> None:
        if self._reference.entity.is_open:
            self._reference.entity.publish(self._make())

    def release(self) -> None:
        """Stop publishing. A second call does nothing."""
        timer, self._timer = self._timer, None
        if timer is not None:
            self._node.destroy_timer(timer)
            self._reference.release()
