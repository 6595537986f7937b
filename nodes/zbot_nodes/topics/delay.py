"""Publish the messages of a topic later.

Run:        zbot run topic_tools delay INPUT SECONDS [OUTPUT]
Parameters: input_topic, output_topic (INPUT_delay), delay (0.0 s), use_wall_clock (false)
"""

from __future__ import annotations

import math
import time
from collections import deque
from typing import TYPE_CHECKING, Any

from zbot.parameters.ros_args import remove_ros_args
from zbot_nodes.startup.program import ParameterError, run_node
from zbot_nodes.topics.topic_tool import TopicTool, number, overrides

if TYPE_CHECKING:
    import zbot

_USAGE = "delay INPUT SECONDS [OUTPUT]"


class Delay(TopicTool):
    """Publishes every message again after a delay."""

    def __init__(self, **options: Any) -> None:
        super().__init__("delay", **options)
        self.input = self.required("input_topic", str, _USAGE)
        self.output = str(self.declare_parameter("output_topic", f"{self.input}_delay").value)
        delay_s = float(self.declare_parameter("delay", 0.0).value)
        if not 0 <= delay_s < math.inf:
            raise ParameterError("the parameter delay must be a finite number, not below 0")
        self.delay_ns = round(delay_s * 1e9)
        self.uses_wall_clock = bool(self.declare_parameter("use_wall_clock", False).value)
        self.waiting: deque[tuple[int, bytes]] = deque()
        self.timer: zbot.Timer | None = None
        self.begin()

    def now_ns(self) -> int:
        """Return the present time."""
        return time.time_ns() if self.uses_wall_clock else self.get_clock().now().nanoseconds

    def process(self, message: bytes) -> None:
        """Keep a message until it is due."""
        self.waiting.append((self.now_ns() + self.delay_ns, message))
        if self.timer is None:
            self.release()

    def release(self) -> None:
        """Publish the messages that are due, and set a timer for the next message."""
        if self.timer is not None:
            self.destroy_timer(self.timer)
            self.timer = None
        now = self.now_ns()
        while self.waiting and self.waiting[0][0] <= now:
            self.pass_on(self.waiting.popleft()[1])
        if self.waiting:
            self.timer = self.create_timer((self.waiting[0][0] - now) / 1e9, self.release)


def read_arguments(words: list[str]) -> list[Any]:
    """Return the parameters that the command line sets.

    Raises:
        ParameterError: The delay is not a number.
    """
    values: list[Any] = list(words)
    values[1:2] = [number(word, "the delay") for word in words[1:2]]
    return overrides(("input_topic", "delay", "output_topic"), values)


def main() -> None:
    """Run until Ctrl-C."""
    words = remove_ros_args()[1:]
    run_node(lambda: Delay(parameter_overrides=read_arguments(words)))


if __name__ == "__main__":
    main()
