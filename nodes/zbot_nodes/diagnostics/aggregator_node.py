"""Group the diagnostics of a robot, and publish the state of each group.

Run:        zbot run diagnostic_aggregator aggregator_node --ros-args --params-file analyzers.yaml
Subscribes: /diagnostics (diagnostic_msgs/DiagnosticArray)
Publishes:  /diagnostics_agg (diagnostic_msgs/DiagnosticArray),
            /diagnostics_toplevel_state (diagnostic_msgs/DiagnosticStatus)
Parameters: path (""), pub_rate (1.0 Hz), other_as_errors (false), history_depth (1000),
            critical (false: report errors only with the next summary), NAME.type, NAME.path ...
"""

from __future__ import annotations

from typing import Any

import zbot
from zbot_nodes.diagnostics.analyzer import ERROR, STALE, OtherAnalyzer, read_group
from zbot_nodes.startup.program import ParameterError, run_node

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus

_MOST_WARNINGS = 1000  #: about messages without a time stamp, one for each set of names


class Aggregator(zbot.Node):
    """Gives each status to the analyzers, and publishes their reports.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__(
            "analyzers",
            allow_undeclared_parameters=True,
            automatically_declare_parameters_from_overrides=True,
            **options,
        )
        path = str(self.setting("path", ""))
        path = f"/{path.strip('/')}" if path.strip("/") else ""
        rate_hz = float(self.setting("pub_rate", 1.0))
        if rate_hz <= 0:
            raise ParameterError("the parameter pub_rate must be above 0")
        self.is_critical = bool(self.setting("critical", False))
        settings = {
            name: parameter.value for name, parameter in self.get_parameters_by_prefix("").items()
        }
        self.group = read_group(path, settings)
        self.other = OtherAnalyzer(
            f"{path}/Other",
            discards_stale=True,
            as_errors=bool(self.setting("other_as_errors", False)),
        )
        self.level = STALE
        self.unstamped: set[str] = set()
        self.publisher = self.create_publisher(DiagnosticArray, "/diagnostics_agg", 1)
        self.state_publisher = self.create_publisher(
            DiagnosticStatus, "/diagnostics_toplevel_state", 1
        )
        depth = int(self.setting("history_depth", 1000))
        self.create_subscription(DiagnosticArray, "/diagnostics", self.accept, depth)
        self.create_timer(1 / rate_hz, self.publish)

    def setting(self, name: str, default: Any) -> Any:
        """Declare a parameter unless it was set, and return its value."""
        if not self.has_parameter(name):
            self.declare_parameter(name, default)
        return self.get_parameter(name).value

    def now_s(self) -> float:
        """Return the present time."""
        return self.get_clock().now().nanoseconds / 1e9

    def accept(self, array: DiagnosticArray) -> None:
        """Give the statuses of a message to the analyzers."""
        names = ", ".join(status.name for status in array.status)
        is_known = names in self.unstamped or len(self.unstamped) >= _MOST_WARNINGS
        if not array.header.stamp.sec and not is_known:
            self.unstamped.add(names)
            text = f"No timestamp set for diagnostic message. Message names: {names}"
            self.get_logger().warn(text)
        for status in array.status:
            if self.is_critical and status.level == ERROR and self.level != ERROR:
                self.level = ERROR
                self.publish_state("toplevel_state_critical", ERROR)
            if not self.group.analyze(status, self.now_s()):
                self.other.analyze(status, self.now_s())

    def publish(self) -> None:
        """Publish the reports, and the worst level."""
        now_s = self.now_s()
        array = DiagnosticArray(status=[*self.group.report(now_s), *self.other.report(now_s)])
        array.header.stamp = self.get_clock().now().to_msg()
        self.publisher.publish(array)
        levels = [status.level for status in array.status]
        self.level = max(levels, default=ERROR)
        if self.level == STALE and min(levels) != STALE:
            self.level = ERROR
        self.publish_state("toplevel_state", self.level)

    def publish_state(self, name: str, level: bytes) -> None:
        """Publish the state of the whole robot."""
        self.state_publisher.publish(DiagnosticStatus(name=name, level=level))


def main() -> None:
    """Run until Ctrl-C."""
    run_node(Aggregator)


if __name__ == "__main__":
    main()
