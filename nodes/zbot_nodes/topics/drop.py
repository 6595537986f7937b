"""Publish the messages of a topic without X of every Y messages.

Run:        zbot run topic_tools drop INPUT X Y [OUTPUT]
Parameters: input_topic, output_topic (INPUT_drop), X, Y, lazy (false)
"""

from __future__ import annotations

from typing import Any

from zbot.parameters.ros_args import remove_ros_args
from zbot_nodes.startup.program import ParameterError, run_node
from zbot_nodes.topics.topic_tool import TopicTool, number, overrides

_USAGE = "drop INPUT X Y [OUTPUT]"


class Drop(TopicTool):
    """Drops the first X of every Y messages."""

    def __init__(self, **options: Any) -> None:
        super().__init__("drop", **options)
        self.input = self.required("input_topic", str, _USAGE)
        self.output = str(self.declare_parameter("output_topic", f"{self.input}_drop").value)
        self.dropped = int(self.required("X", int, _USAGE))
        self.group = int(self.required("Y", int, _USAGE))
        if not 0 <= self.dropped <= self.group or self.group == 0:
            raise ParameterError("X and Y must be 0 <= X <= Y, and Y must be above 0")
        self.count = 0
        self.begin()

    def process(self, message: bytes) -> None:
        """Count a message. Publish the message if it is not one of the first X."""
        if self.count >= self.dropped:
            self.pass_on(message)
        self.count = (self.count + 1) % self.group


def read_arguments(words: list[str]) -> list[Any]:
    """Return the parameters that the command line sets.

    Raises:
        ParameterError: X or Y is not a number.
    """
    values: list[Any] = list(words)
    values[1:3] = [int(number(word, name)) for word, name in zip(words[1:3], "XY", strict=False)]
    return overrides(("input_topic", "X", "Y", "output_topic"), values)


def main() -> None:
    """Run until Ctrl-C."""
    words = remove_ros_args()[1:]
    run_node(lambda: Drop(parameter_overrides=read_arguments(words)))


if __name__ == "__main__":
    main()
