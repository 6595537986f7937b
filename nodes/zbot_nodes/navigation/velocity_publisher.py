"""Publisher and subscription of velocities, as Twist or as TwistStamped."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from geometry_msgs.msg import Twist, TwistStamped

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot_nodes.navigation.managed_server import ManagedServer


class VelocityPublisher:
    """Publisher of the velocities of a node.

    Args:
        node: The node. Its parameter `enable_stamped_cmd_vel` says which type it publishes.
        topic: The topic.
    """

    def __init__(self, node: ManagedServer, topic: str) -> None:
        self._node = node
        self.is_stamped = node.settings.flag("enable_stamped_cmd_vel", default=False)
        kind = TwistStamped if self.is_stamped else Twist
        self._publisher = node.create_publisher(kind, topic, 10)

    def publish(self, forward: float, turn: float, left: float = 0.0) -> None:
        """Publish a velocity in m/s and rad/s."""
        twist = Twist()
        twist.linear.x, twist.linear.y, twist.angular.z = forward, left, turn
        if not self.is_stamped:
            self._publisher.publish(twist)
            return
        message = TwistStamped(twist=twist)
        message.header.stamp, message.header.frame_id = self._node.stamp(), "base_link"
        self._publisher.publish(message)

    def close(self) -> None:
        """Destroy the publisher."""
        self._node.destroy_publisher(self._publisher)


def velocity_subscription(node: ManagedServer, topic: str, take: Callable[[Any], object]) -> Any:
    """Return a subscription that calls a function with each Twist, also from a TwistStamped."""
    if not node.settings.flag("enable_stamped_cmd_vel", default=False):
        return node.create_subscription(Twist, topic, take, 10)
    return node.create_subscription(TwistStamped, topic, lambda message: take(message.twist), 10)
