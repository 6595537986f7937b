"""Publish messages of a topic with a limit: messages per second, or bytes per second.

Run:        zbot run topic_tools throttle messages INPUT MESSAGES_PER_SECOND [OUTPUT]
            zbot run topic_tools throttle bytes INPUT BYTES_PER_SECOND WINDOW_SECONDS [OUTPUT]
Parameters: throttle_type, input_topic, output_topic (INPUT_throttle), lazy (false),
            msgs_per_sec, bytes_per_sec, window, use_wall_clock (false)
"""

from __future__ import annotations

import math
import time
from collections import deque
from typing import Any

from zbot.parameters.ros_args import remove_ros_args
from zbot_nodes.startup.program import ParameterError, run_node
from zbot_nodes.topics.topic_tool import TopicTool, number, overrides

_USAGE = "throttle messages INPUT RATE [OUTPUT], or throttle bytes INPUT BYTES WINDOW [OUTPUT]"
_KINDS = ("messages", "bytes")


class Throttle(TopicTool):
    """Drops messages above the limit."""

    def __init__(self, **options: Any) -> None:
        super().__init__("throttle", **options)
        self.input = self.required("input_topic", str, _USAGE)
        self.output = str(self.declare_parameter("output_topic", f"{self.input}_throttle").value)
        self.kind = self.required("throttle_type", str, _USAGE)
        if self.kind not in _KINDS:
            raise ParameterError(f"throttle_type must be messages or bytes, not '{self.kind}'")
        self.period_ns, self.limit, self.window_ns = 0, 0, 0
        if self.kind == "messages":
            self.period_ns = round(1e9 / self.positive("msgs_per_sec", float))
        else:
            self.limit = int(self.positive("bytes_per_sec", int))
            self.window_ns = round(1e9 * self.positive("window", float))
        self.uses_wall_clock = bool(self.declare_parameter("use_wall_clock", False).value)
        self.sent: deque[tuple[int, int]] = deque()  #: time in ns and size of sent messages
        self.last_ns = self.now_ns()
        self.begin()

    def positive(self, name: str, kind: type) -> float:
        """Return a parameter that must be above 0."""
        value = float(self.required(name, kind, _USAGE))
        if not 0 < value < math.inf:
            raise ParameterError(f"the parameter {name} must be a finite number above 0")
        return value

    def now_ns(self) -> int:
        """Return the present time."""
        return time.time_ns() if self.uses_wall_clock else self.get_clock().now().nanoseconds

    def process(self, message: bytes) -> None:
        """Publish a message if the limit allows it."""
        now = self.now_ns()
        if self.kind == "messages":
            if now < self.last_ns:
                self.get_logger().warn("Detected jump back in time, resetting throttle period")
                self.last_ns = now
            if now - self.last_ns >= self.period_ns:
                self.last_ns = now
                self.pass_on(message)
            return
        while self.sent and self.sent[0][0] < now - self.window_ns:
            self.sent.popleft()
        if sum(size for _, size in self.sent) < self.limit:
            self.sent.append((now, len(message)))
            self.pass_on(message)


def read_arguments(words: list[str]) -> list[Any]:
    """Return the parameters that the command line sets.

    Raises:
        ParameterError: A rate, a number of bytes or a window is not a number.
    """
    if not words or words[0] not in _KINDS:
        return []
    kind, *rest = words
    names: tuple[str, ...] = ("input_topic", "msgs_per_sec", "output_topic")
    values: list[Any] = list(rest)
    if kind == "bytes":
        names = ("input_topic", "bytes_per_sec", "window", "output_topic")
        values[1:2] = [int(number(word, names[1])) for word in rest[1:2]]
        values[2:3] = [number(word, names[2]) for word in rest[2:3]]
    else:
        values[1:2] = [number(word, names[1]) for word in rest[1:2]]
    return overrides(("throttle_type", *names), [kind, *values])


def main() -> None:
    """Run until Ctrl-C."""
    words = remove_ros_args()[1:]
    run_node(lambda: Throttle(parameter_overrides=read_arguments(words)))


if __name__ == "__main__":
    main()
