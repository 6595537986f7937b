"""Time source that sets clocks from `/clock` while a node's `use_sim_time` is true."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

from zbot.executor.callback_group import MutuallyExclusiveCallbackGroup
from zbot.executor.clock import ROSClock
from zbot.executor.errors import clock_type_error
from zbot.node.parameters import USE_SIM_TIME
from zbot.qos import QoSProfile, ReliabilityPolicy
from zbot.time import ClockType, Time

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.callback_group import CallbackGroup
    from zbot.node.lockstep import LockstepAnswer
    from zbot.node.state import NodeState
    from zbot.node.subscription import Subscription

CLOCK_TOPIC = "/clock"


class TimedNode(Protocol):
    """The part of a node that a time source uses."""

    @property
    def handle(self) -> NodeState:
        """The node's internal state."""
        ...

    def has_parameter(self, name: str) -> bool:
        """Return whether a parameter is declared."""
        ...

    def declare_parameter(self, name: str, value: Any = None) -> object:
        """Declare a parameter."""
        ...

    def create_subscription(
        self,
        msg_type: type[Any],
        topic: str,
        callback: Callable[..., Any],
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
    ) -> Subscription[Any]:
        """Create a subscription."""
        ...

    def destroy_subscription(self, subscription: Subscription[Any]) -> bool:
        """Destroy a subscription."""
        ...


class TimeSource:
    """Sets clocks to the time of `/clock`, or to the system's time.

    Args:
        node: The node that has `use_sim_time` and subscribes to `/clock`. The program can also
            attach the node later.
    """

    def __init__(self, *, node: TimedNode | None = None) -> None:
        self._node: TimedNode | None = None
        self._clocks: list[ROSClock] = []
        self._last_time = Time(clock_type=ClockType.ROS_TIME)
        self._is_active = False
        # A separate group lets `/clock` advance the time while a callback waits for a later time.
        self._group = MutuallyExclusiveCallbackGroup()
        self._clock_sub: Subscription[Any] | None = None
        self._answer: LockstepAnswer | None = None
        if node is not None:
            self.attach_node(node)

    @property
    def ros_time_is_active(self) -> bool:
        """Whether the clocks are simulated."""
        return self._is_active

    @ros_time_is_active.setter
    def ros_time_is_active(self, active: bool) -> None:
        if active == self._is_active:
            return
        self._is_active = active
        self._subscribe() if active else self._unsubscribe()
        for clock in self._clocks:
            clock.set_ros_time_is_active(active)

    def _get_node(self) -> TimedNode | None:
        return self._node

    def attach_node(self, node: TimedNode) -> None:
        """From now on, follow the `use_sim_time` of this node and not of the former node."""
        self.detach_node()
        if not node.has_parameter(USE_SIM_TIME):
            node.declare_parameter(USE_SIM_TIME, False)
        self._node = node
        # As in rclpy, the time source that was attached last is called first and subscribes first.
        node.handle.parameters.post_set.insert(0, self._follow)
        self._follow()
        self._subscribe()

    def detach_node(self) -> None:
        """Detach the node. Simulated clocks stay simulated, and keep the last time of `/clock`."""
        if self._node is not None:
            self._unsubscribe()
            self._node.handle.parameters.post_set.remove(self._follow)
            self._node = None

    def attach_clock(self, clock: ROSClock) -> None:
        """Add another clock, which this time source sets too.

        Raises:
            WrongValueError: The clock is not a ROS time clock.
        """
        if not isinstance(clock, ROSClock):
            raise clock_type_error("ROS_TIME", repr(clock))
        clock.set_ros_time_override(self._last_time)
        clock.set_ros_time_is_active(self._is_active)
        self._clocks.append(clock)

    def clock_callback(self, msg: Any) -> None:
        """Set the clocks to the time of a `rosgraph_msgs/msg/Clock`."""
        self._last_time = Time.from_msg(msg.clock, clock_type=ClockType.ROS_TIME)
        for clock in self._clocks:
            clock.set_ros_time_override(self._last_time)

    def _follow(self, _: object = None) -> None:
        if self._node is not None:
            parameter = self._node.handle.parameters.values.get(USE_SIM_TIME)
            self.ros_time_is_active = parameter is not None and parameter.value is True

    def _subscribe(self) -> None:
        if not self._is_active or self._node is None or self._clock_sub is not None:
            return
        from zbot.node.lockstep import LockstepAnswer  # noqa: PLC0415 - few nodes use simulated time

        from rosgraph_msgs.msg import Clock  # noqa: PLC0415 - as above

        # A simulator that sees the subscription must be able to ask the node.
        self._answer = LockstepAnswer(self._node.handle, self._node.handle.clock)
        profile = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
        self._clock_sub = self._node.create_subscription(
            Clock, CLOCK_TOPIC, self.clock_callback, profile, callback_group=self._group
        )

    def _unsubscribe(self) -> None:
        if self._node is not None and self._clock_sub is not None:
            self._node.destroy_subscription(self._clock_sub)
        self._clock_sub = None
        if self._answer is not None:
            self._answer.destroy()
        self._answer = None
