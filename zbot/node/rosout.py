"""Publisher of a node's log lines on `/rosout`."""

from __future__ import annotations

import contextlib
import weakref
from functools import partial
from typing import TYPE_CHECKING, Any

from zbot.errors import InvalidHandleError, NotInitializedError
from zbot.log import add_sink, remove_sink
from zbot.names import ROSOUT_TOPIC

if TYPE_CHECKING:
    from zbot.log import Record
    from zbot.node.entities import NodeEntities
    from zbot.qos import QoSProfile


class Rosout:
    """Publishes the log lines of a node's logger and of this logger's children.

    Args:
        node: The node of the logger.
        qos: Quality of service of the topic.
    """

    def __init__(self, node: NodeEntities, qos: QoSProfile) -> None:
        from builtin_interfaces.msg import Time  # noqa: PLC0415 - the import makes the class
        from rcl_interfaces.msg import Log  # noqa: PLC0415 - the import makes the class

        self._log, self._time = Log, Time
        self._name = node.handle.logger_name
        self._diagnostics = node.handle.diagnostics
        self._publisher: Any = node.create_publisher(Log, ROSOUT_TOPIC, qos)
        node.handle.publishers.remove(self._publisher)  # as in rclpy, the node does not list it
        self._send = self._publisher.publish  # kept, because programs may patch the class later
        # The log exists longer than a context, and must not keep the context's nodes alive. So the
        # log gets a function with a weak reference.
        sink = partial(_pass_on, weakref.ref(self))
        add_sink(self._name, sink)
        self._leave_log = weakref.finalize(self, remove_sink, self._name, sink)
        self._leave_log.atexit = False

    def publish(self, record: Record) -> None:
        """Publish a log line if the publisher is still open."""
        if self._publisher.is_open:
            # Another thread may end the context or the node meanwhile.
            with contextlib.suppress(NotInitializedError, InvalidHandleError):
                self._send(self._message(record))

    def _message(self, record: Record) -> Any:
        sec, nanosec = divmod(record.stamp_ns, 10**9)
        return self._log(
            stamp=self._time(sec=sec, nanosec=nanosec),
            level=int(record.level),
            name=record.name,
            msg=record.message,
            file=record.file,
            function=record.function,
            line=record.line,
        )

    def close(self) -> None:
        """Stop publishing, and leave the topic."""
        self._leave_log()
        self._diagnostics.remove(self._publisher.token)
        self._publisher.destroy()


def _pass_on(receiver: weakref.ref[Rosout], record: Record) -> None:
    rosout = receiver()
    if rosout is not None:
        rosout.publish(record)
