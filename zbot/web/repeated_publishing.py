"""A message that is published again and again."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.timer import Timer
    from zbot.node.node import Node
    from zbot.node.publisher import Publisher
    from zbot.web.lease import Lease


class RepeatedPublishing:
    """Publishes at a rate, in the node's thread, until it is released.

    Args:
        node: Whose timer it is.
        lease: The publisher; released at the end.
        make: Returns the message; called each time, so that stamps tell the present.
        rate_hz: How often.
    """

    def __init__(
        self, node: Node, lease: Lease[Publisher[Any]], make: Callable[[], Any], rate_hz: float
    ) -> None:
        self._node, self._lease = node, lease
        self._make, self._rate_hz = make, rate_hz
        self._timer: Timer | None = node.create_timer(1 / rate_hz, self._publish)
        self._publish()

    def change(self, make: Callable[[], Any], rate_hz: float) -> None:
        """Publish something else, or at another rate, from now on."""
        self._make = make
        if rate_hz != self._rate_hz and self._timer is not None:
            self._rate_hz = rate_hz
            self._node.destroy_timer(self._timer)
            self._timer = self._node.create_timer(1 / rate_hz, self._publish)

    def _publish(self) -> None:
        if self._lease.entity.is_open:
            self._lease.entity.publish(self._make())

    def release(self) -> None:
        """Publish no more; may be called twice."""
        timer, self._timer = self._timer, None
        if timer is not None:
            self._node.destroy_timer(timer)
            self._lease.release()
