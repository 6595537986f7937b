"""Choose between sources of velocities: the source with the highest priority drives the robot.

Run:        zbot run twist_mux twist_mux --ros-args --params-file twist_mux.yaml
Subscribes: topics.NAME.topic (geometry_msgs/TwistStamped, or Twist if use_stamped is false);
            locks.NAME.topic (std_msgs/Bool): true stops sources below the lock's priority
Publishes:  cmd_vel_out (TwistStamped or Twist), diagnostics (diagnostic_msgs/DiagnosticArray)
Parameters: use_stamped (true; if it is not set, the node changes to the type of the other nodes);
            topics.NAME.topic, .timeout (s; 0: none), .priority (1 to 255);
            locks.NAME.topic, .timeout, .priority
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import zbot
from zbot_nodes.startup.program import ParameterError, run_node

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
from geometry_msgs.msg import Twist, TwistStamped
from std_msgs.msg import Bool

_DEPTH = 10
_HIGHEST = 255
_DIAGNOSTICS_S = 1.0
_FOLLOW_S = 0.5


@dataclass
class Source:
    """A topic with velocities, or a lock."""

    name: str
    topic: str
    timeout_s: float  #: 0 means that messages never become too old
    priority: int
    received_ns: int = 0
    is_locked: bool = False  #: the last message of a lock

    def has_expired(self, now_ns: int) -> bool:
        """Return whether the last message is too old, or no message has come.

        Without a timeout, return False.
        """
        return self.timeout_s > 0 and now_ns - self.received_ns > self.timeout_s * 1e9

    def locks(self, now_ns: int) -> bool:
        """Return whether a lock is in force. A lock without recent messages is in force too."""
        return self.has_expired(now_ns) or self.is_locked


class TwistMux(zbot.Node):
    """Publishes the velocities of the source that drives the robot.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__(
            "twist_mux",
            allow_undeclared_parameters=True,
            automatically_declare_parameters_from_overrides=True,
            **options,
        )
        is_chosen = self.has_parameter("use_stamped")
        if not is_chosen:
            self.declare_parameter("use_stamped", True)
        self.kind: Any = TwistStamped if self.get_parameter("use_stamped").value else Twist
        self.velocities = self.read_sources("topics")
        self.locks = self.read_sources("locks")
        if not self.velocities:
            self.get_logger().warn(
                "No source is set: give parameters such as topics.joystick.topic"
            )
        self.diagnostics = self.create_publisher(DiagnosticArray, "/diagnostics", 1)
        self.publisher: zbot.Publisher[Any] | None = None
        self.subscriptions_of_velocities: list[zbot.Subscription[Any]] = []
        self.connect()
        for source in (*self.velocities, *self.locks):
            self.tell(source)
        for lock in self.locks:
            self.listen(lock, Bool, self.set_lock)
        self.create_timer(_DIAGNOSTICS_S, self.report)
        if not is_chosen:
            real = zbot.Clock(clock_type=zbot.ClockType.STEADY_TIME)
            self.create_timer(_FOLLOW_S, self.follow, clock=real)

    def connect(self) -> None:
        """Publish and subscribe with the present type of message."""
        for subscription in self.subscriptions_of_velocities:
            self.destroy_subscription(subscription)
        if self.publisher is not None:
            self.destroy_publisher(self.publisher)
        self.publisher = self.create_publisher(self.kind, "cmd_vel_out", 1)
        self.subscriptions_of_velocities = [
            self.listen(source, self.kind, self.pass_on) for source in self.velocities
        ]

    def follow(self) -> None:
        """Change to the message type of the other nodes, if they all use the same type.

        This is called only if use_stamped is not set. In ROS 2 Humble, twist_mux has only Twist and
        no parameter use_stamped. So parameter files for Humble do not set it.
        """
        output = self.resolve_topic_name("cmd_vel_out")
        others = {
            subscription.topic_type for subscription in self.get_subscriptions_info_by_topic(output)
        }
        for source in self.velocities:
            topic = self.resolve_topic_name(source.topic)
            others |= {
                publisher.topic_type for publisher in self.get_publishers_info_by_topic(topic)
            }
        for kind in (Twist, TwistStamped):
            if others == {f"geometry_msgs/msg/{kind.__name__}"} and self.kind is not kind:
                self.kind = kind
                self.connect()
                name = kind.__name__
                self.get_logger().info(f"use_stamped is not set: the other nodes use {name}")

    def read_sources(self, group: str) -> list[Source]:
        """Return the sources of the parameters `topics` or `locks`."""
        settings: dict[str, dict[str, Any]] = {}
        for name, parameter in self.get_parameters_by_prefix(group).items():
            source, _, key = name.rpartition(".")
            settings.setdefault(source, {})[key] = parameter.value
        return [self.source(group, name, facts) for name, facts in settings.items()]

    def source(self, group: str, name: str, settings: dict[str, Any]) -> Source:
        """Return a source with its settings."""
        missing = [key for key in ("topic", "timeout", "priority") if key not in settings]
        if missing:
            raise ParameterError(f"the parameter {group}.{name}.{missing[0]} is missing")
        try:
            timeout_s, priority = float(settings["timeout"]), int(settings["priority"])
        except (TypeError, ValueError):
            raise ParameterError(
                f"timeout and priority of {group}.{name} must be numbers"
            ) from None
        return Source(name, str(settings["topic"]), timeout_s, min(max(priority, 0), _HIGHEST))

    def listen(self, source: Source, kind: Any, callback: Any) -> zbot.Subscription[Any]:
        """Subscribe to the topic of a source."""
        return self.create_subscription(
            kind, source.topic, lambda message: callback(source, message), _DEPTH
        )

    def tell(self, source: Source) -> None:
        """Log the settings of a source."""
        timeout = f"{source.timeout_s:f}s" if source.timeout_s > 0 else "None"
        self.get_logger().info(
            f"Topic handler '{source.name}' subscribed to topic '{source.topic}': "
            f"timeout = {timeout} , priority = {source.priority}."
        )

    def now_ns(self) -> int:
        """Return the present time."""
        return self.get_clock().now().nanoseconds

    def pass_on(self, source: Source, message: Any) -> None:
        """Publish the message of a source if this source drives the robot."""
        source.received_ns = self.now_ns()
        if self.active() is source and self.publisher is not None:
            self.publisher.publish(message)

    def set_lock(self, lock: Source, message: Bool) -> None:
        """Store the state of a lock."""
        lock.received_ns, lock.is_locked = self.now_ns(), message.data

    def lock_priority(self) -> int:
        """Return the highest priority of the locks in force, or 0 if no lock is in force."""
        now = self.now_ns()
        return max((lock.priority for lock in self.locks if lock.locks(now)), default=0)

    def is_masked(self, source: Source) -> bool:
        """Return whether a source has no recent message, or a lock has a higher priority."""
        return source.has_expired(self.now_ns()) or source.priority < self.lock_priority()

    def active(self) -> Source | None:
        """Return the source that drives the robot: the source with the highest priority.

        If sources have the same priority, the first source in the parameters drives. A source with
        priority 0 never drives.
        """
        free = [
            source
            for source in self.velocities
            if source.priority > 0 and not self.is_masked(source)
        ]
        return max(free, key=lambda source: source.priority, default=None)

    def report(self) -> None:
        """Publish the state of all sources."""
        now = self.now_ns()
        status = DiagnosticStatus(
            name=f"{self.get_name()}: Twist mux status", message="ok", hardware_id="none"
        )
        for source in self.velocities:
            self.add(
                status,
                f"velocity {source.name}",
                source,
                self.is_masked(source),
                "masked",
                "unmasked",
            )
        for lock in self.locks:
            self.add(status, f"lock {lock.name}", lock, lock.locks(now), "locked", "free")
        status.values.append(KeyValue(key="current priority", value=str(self.lock_priority())))
        array = DiagnosticArray(status=[status])
        array.header.stamp = self.get_clock().now().to_msg()
        self.diagnostics.publish(array)

    @staticmethod
    def add(  # noqa: PLR0917 - a row of the report
        status: DiagnosticStatus, key: str, source: Source, is_on: bool, yes: str, no: str
    ) -> None:
        """Add the state of a source to the report."""
        text = f" {yes if is_on else no} (listening to {source.topic} @ {source.timeout_s:f}s with "
        status.values.append(KeyValue(key=key, value=f"{text}priority #{source.priority})"))


def main() -> None:
    """Run until Ctrl-C."""
    run_node(TwistMux)


if __name__ == "__main__":
    main()
