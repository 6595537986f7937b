"""Simulated time: a node's clock follows `/clock` while `use_sim_time` is true."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.qos import QoSProfile, ReliabilityPolicy
from zbot.time import ClockType, Time

if TYPE_CHECKING:
    from zbot.clock import ROSClock
    from zbot.node import Node
    from zbot.subscription import Subscription

CLOCK_TOPIC = "/clock"


class TimeSource:
    """Feeds a node's clock from `/clock`, or leaves it on the system's time.

    Args:
        node: Whose clock is fed; the subscription is one of its own.
        clock: A clock of ROS time.
    """

    def __init__(self, node: Node, clock: ROSClock) -> None:
        self._node = node
        self._clock = clock
        self._subscription: Subscription[Any] | None = None

    @property
    def ros_time_is_active(self) -> bool:
        """Whether the clock is simulated."""
        return self._subscription is not None

    @ros_time_is_active.setter
    def ros_time_is_active(self, active: bool) -> None:
        if active == self.ros_time_is_active:
            return
        if active:
            self._subscribe()
        elif self._subscription is not None:
            self._node.destroy_subscription(self._subscription)
            self._subscription = None
        self._clock.set_ros_time_is_active(active)

    def _subscribe(self) -> None:
        from rosgraph_msgs.msg import Clock  # noqa: PLC0415 - simulation is the exception

        profile = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
        self._subscription = self._node.create_subscription(
            Clock, CLOCK_TOPIC, self._on_clock, profile
        )

    def _on_clock(self, message: Any) -> None:
        self._clock.set_ros_time_override(
            Time.from_msg(message.clock, clock_type=ClockType.ROS_TIME)
        )
