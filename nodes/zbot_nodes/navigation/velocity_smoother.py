"""Limit the speed and the acceleration of commands.

Run:        zbot run nav2_velocity_smoother velocity_smoother, then configure and activate it
Subscribes: cmd_vel (geometry_msgs/Twist, or TwistStamped with enable_stamped_cmd_vel)
Publishes:  cmd_vel_smoothed (of the same type)
"""

from __future__ import annotations

from typing import Any

from zbot_nodes.navigation.managed_server import ManagedServer
from zbot_nodes.navigation.velocity_publisher import VelocityPublisher, velocity_subscription
from zbot_nodes.startup.program import run_node

_STOPPED = (0.0, 0.0, 0.0)


class VelocitySmoother(ManagedServer):
    """Publishes velocities that go to the last command without jumps.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("velocity_smoother", **options)
        self.wanted: tuple[float, ...] = _STOPPED
        self.last: tuple[float, ...] = _STOPPED
        self.came_s = 0.0
        self.is_moving = False

    def configure(self) -> None:
        """Create the topics."""
        numbers = self.settings.numbers
        self.period_s = 1 / max(self.settings.number("smoothing_frequency", 20.0), 1.0)
        self.fastest = numbers("max_velocity", [0.5, 0.0, 2.5])
        self.slowest = numbers("min_velocity", [-0.5, 0.0, -2.5])
        self.faster = numbers("max_accel", [2.5, 0.0, 3.2])
        self.slower = numbers("max_decel", [-2.5, 0.0, -3.2])
        self.deadband = numbers("deadband_velocity", [0.0, 0.0, 0.0])
        self.timeout_s = self.settings.number("velocity_timeout", 1.0)
        self.velocities = VelocityPublisher(self, "cmd_vel_smoothed")
        self.commands = velocity_subscription(self, "cmd_vel", self.take)
        self.timer = self.create_timer(self.period_s, self.step)

    def clean_up(self) -> None:
        """Destroy the topics."""
        self.velocities.close()
        self.destroy_subscription(self.commands)
        self.destroy_timer(self.timer)

    def take(self, twist: Any) -> None:
        """Store a command, cut to the limits."""
        command = (twist.linear.x, twist.linear.y, twist.angular.z)
        limits = zip(command, self.slowest, self.fastest, strict=True)
        self.wanted = tuple(max(low, min(high, value)) for value, low, high in limits)
        self.came_s, self.is_moving = self.seconds(), True

    def step(self) -> None:
        """Publish the next velocity. A robot that has stopped gets none."""
        if not self.is_active or not self.is_moving:
            return
        if self.seconds() - self.came_s > self.timeout_s:
            self.wanted = _STOPPED
            self.is_moving = self.last != _STOPPED
        self.last = tuple(self.nearer(axis) for axis in range(3))
        shown = [
            value if abs(value) >= least else 0.0
            for value, least in zip(self.last, self.deadband, strict=True)
        ]
        self.velocities.publish(shown[0], shown[2], shown[1])

    def nearer(self, axis: int) -> float:
        """Return the velocity along an axis after one step towards the command."""
        last, change = self.last[axis], self.wanted[axis] - self.last[axis]
        is_faster = abs(self.wanted[axis]) > abs(last) and self.wanted[axis] * last >= 0
        limit = abs(self.faster[axis] if is_faster else self.slower[axis]) * self.period_s
        return last + max(-limit, min(limit, change)) if limit else self.wanted[axis]


def main() -> None:
    """Run until Ctrl-C."""
    run_node(VelocitySmoother)


if __name__ == "__main__":
    main()
