"""Robot whose transforms a diagnosis hears, with a clock that the test moves."""

from __future__ import annotations

from typing import Any

from zbot.tf2.diagnosis import Diagnosis, Problem

from geometry_msgs.msg import TransformStamped
from tf2_msgs.msg import TFMessage

SECOND = 10**9
START_NS = 1_763_900_000 * SECOND  # November 2025


class Robot:
    """Publisher of transforms, and the diagnosis that hears them."""

    def __init__(self) -> None:
        self.diagnosis = Diagnosis()
        self.now_ns = START_NS
        self.publishers: dict[str, list[str]] = {}
        self.listeners: dict[str, list[str]] = {}
        self.last_message: Any = None

    def publish(
        self,
        parent: str,
        child: str,
        *,
        node: str = "/driver",
        topic: str = "/tf",
        stamp_ns: int | None = None,
        clock_error_ns: int = 0,
        x: float = 0.0,
    ) -> None:
        message: Any = TransformStamped(child_frame_id=child)
        message.header.frame_id = parent
        stamp = self.now_ns + clock_error_ns if stamp_ns is None else stamp_ns
        message.header.stamp.sec, message.header.stamp.nanosec = divmod(stamp, SECOND)
        message.transform.translation.x = x
        message.transform.rotation.w = 1.0
        self.last_message = message
        self.diagnosis.add_message(
            TFMessage(transforms=[message]),
            topic,
            received_ns=self.now_ns,
            sent_ns=self.now_ns + clock_error_ns,
            publisher=node,
        )
        nodes = self.publishers.setdefault(topic, [])
        if node not in nodes:
            nodes.append(node)
        self.diagnosis.set_endpoints(self.publishers, self.listeners)

    def drive(self, *links: tuple[str, str], seconds: float = 2.0, **options: Any) -> None:
        """Publish links ten times a second. They move."""
        for _ in range(round(seconds * 10)):
            for parent, child in links:
                x = self.now_ns / SECOND % 1000
                self.publish(parent, child, x=x, **options)
            self.wait(0.1)

    def fix(self, parent: str, child: str, **options: Any) -> None:
        """Publish a static link."""
        topic = options.pop("topic", "/tf_static")
        self.publish(parent, child, **{"node": "/mount", "topic": topic, **options})

    def wait(self, seconds: float) -> None:
        self.now_ns += round(seconds * SECOND)

    def end(self, node: str) -> None:
        """End a node."""
        for nodes in self.publishers.values():
            if node in nodes:
                nodes.remove(node)

    def why(self, target: str, source: str, age_s: float | None = None, **options: Any) -> Problem:
        """Return why a transform is missing, for a scan of a given age."""
        stamp_ns = 0 if age_s is None else self.now_ns - round(age_s * SECOND)
        stamp_ns = options.pop("stamp_ns", stamp_ns)
        found = self.diagnosis.why(
            target,
            source,
            stamp_ns,
            what="the newest scan",
            message_topic="/scan",
            now_ns=self.now_ns,
            **options,
        )
        assert found is not None
        return found

    def knows(self, target: str, source: str, age_s: float | None = None) -> bool:
        stamp_ns = 0 if age_s is None else self.now_ns - round(age_s * SECOND)
        return self.diagnosis.why(target, source, stamp_ns, now_ns=self.now_ns) is None

    def problems(self) -> list[Problem]:
        return self.diagnosis.problems(now_ns=self.now_ns)

    def problem(self) -> Problem:
        """Return the only problem."""
        (found,) = self.problems()
        return found
