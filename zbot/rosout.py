"""A node's log lines on `/rosout`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.log import add_sink, remove_sink
from zbot.names import ROSOUT_TOPIC

if TYPE_CHECKING:
    from zbot.log import Record
    from zbot.node import Node
    from zbot.qos import QoSProfile


class Rosout:
    """Publishes what a node's logger and its children write.

    Args:
        node: Whose logger it is.
        qos: Quality of service of the topic.
    """

    def __init__(self, node: Node, qos: QoSProfile) -> None:
        from builtin_interfaces.msg import Time  # noqa: PLC0415 - made at first import
        from rcl_interfaces.msg import Log  # noqa: PLC0415 - made at first import

        self._log, self._time = Log, Time
        self._name = node.handle.logger_name
        self._adviser = node.handle.adviser
        self._publisher: Any = node.create_publisher(Log, ROSOUT_TOPIC, qos)
        node.handle.publishers.remove(self._publisher)  # as in rclpy, the node does not list it
        self._send = self._publisher.publish  # once: a program may put its own in the class later
        add_sink(self._name, self._publish)

    def _publish(self, record: Record) -> None:
        if self._publisher.is_open:
            sec, nanosec = divmod(record.stamp_ns, 10**9)
            self._send(
                self._log(
                    stamp=self._time(sec=sec, nanosec=nanosec),
                    level=int(record.level),
                    name=record.name,
                    msg=record.message,
                    file=record.file,
                    function=record.function,
                    line=record.line,
                )
            )

    def close(self) -> None:
        """Stop publishing, and leave the topic."""
        remove_sink(self._name, self._publish)
        self._adviser.remove(self._publisher.token)
        self._publisher.destroy()
