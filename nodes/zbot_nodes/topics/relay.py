"""Publish the messages of a topic on another topic.

Run:        zbot run topic_tools relay INPUT [OUTPUT]
Parameters: input_topic, output_topic (INPUT_relay), lazy (false: subscribe always)
"""

from __future__ import annotations

from typing import Any

from zbot.parameters.ros_args import remove_ros_args
from zbot_nodes.startup.program import run_node
from zbot_nodes.topics.topic_tool import TopicTool, overrides

_USAGE = "relay INPUT [OUTPUT]"


class Relay(TopicTool):
    """Publishes every message of the input."""

    def __init__(self, **options: Any) -> None:
        super().__init__("relay", **options)
        self.input = self.required("input_topic", str, _USAGE)
        self.output = str(self.declare_parameter("output_topic", f"{self.input}_relay").value)
        self.begin()


def main() -> None:
    """Run until Ctrl-C."""
    given = overrides(("input_topic", "output_topic"), remove_ros_args()[1:])
    run_node(lambda: Relay(parameter_overrides=given))


if __name__ == "__main__":
    main()
