"""Publish the messages of one of several topics. Services choose the topic.

Run:        zbot run topic_tools mux OUTPUT INPUT...
Serves:     ~/select, ~/add, ~/delete, ~/list (topic_tools_interfaces)
Parameters: input_topics, output_topic ("~/selected"), initial_topic ("": the first input),
            lazy (false)
"""

from __future__ import annotations

from typing import Any

import zbot
from zbot.parameters.ros_args import remove_ros_args
from zbot_nodes.startup.program import ParameterError, run_node
from zbot_nodes.topics.topic_tool import TopicTool

from rcl_interfaces.msg import ParameterDescriptor
from topic_tools_interfaces.srv import MuxAdd, MuxDelete, MuxList, MuxSelect

NONE = "__none"


class Mux(TopicTool):
    """Publishes the messages of the chosen topic."""

    def __init__(self, **options: Any) -> None:
        super().__init__("mux", **options)
        self.output = str(self.declare_parameter("output_topic", "~/selected").value)
        any_type = ParameterDescriptor(dynamic_typing=True)
        names = self.declare_parameter("input_topics", [], any_type).value
        self.inputs = [str(name) for name in names]
        if not self.inputs:
            raise ParameterError("the parameter input_topics is missing: mux OUTPUT INPUT...")
        first = str(self.declare_parameter("initial_topic", "").value)
        self.input = first or self.inputs[0]
        self.create_service(MuxSelect, "~/select", self.select)
        self.create_service(MuxAdd, "~/add", self.add)
        self.create_service(MuxDelete, "~/delete", self.delete)
        self.create_service(MuxList, "~/list", self.tell)
        self.begin()

    def match(self) -> None:
        """Connect with the publishers of the chosen topic. Disconnect if no topic is chosen."""
        if self.input == NONE:
            self.forget()
        else:
            super().match()

    def known(self, topic: str) -> str | None:
        """Return the input of this name. The name may be relative or absolute."""
        wanted = self.resolve_topic_name(topic)
        return next((o for o in self.inputs if self.resolve_topic_name(o) == wanted), None)

    def select(
        self, request: MuxSelect.Request, response: MuxSelect.Response
    ) -> MuxSelect.Response:
        """Choose an input."""
        response.prev_topic = "" if self.input == NONE else self.input
        response.success = request.topic == NONE or self.known(request.topic) is not None
        if response.success:
            self.input = request.topic
            self.match()
            self.get_logger().info(f"mux selected input: [{request.topic}]")
        return response

    def add(self, request: MuxAdd.Request, response: MuxAdd.Response) -> MuxAdd.Response:
        """Add an input."""
        response.success = request.topic not in {NONE, ""} and self.known(request.topic) is None
        if response.success:
            self.inputs.append(request.topic)
            self.get_logger().info(f"added {request.topic} to mux")
        else:
            self.get_logger().warn(f"failed to add topic {request.topic} to mux")
        return response

    def delete(
        self, request: MuxDelete.Request, response: MuxDelete.Response
    ) -> MuxDelete.Response:
        """Remove an input that is not chosen."""
        known = self.known(request.topic) if request.topic else None
        response.success = known is not None and known != self.known(self.input)
        if response.success and known is not None:
            self.inputs.remove(known)
            self.get_logger().info(f"deleted topic {request.topic} from mux")
        else:
            self.get_logger().warn(f"failed to delete topic {request.topic} from mux")
        return response

    def tell(self, _request: MuxList.Request, response: MuxList.Response) -> MuxList.Response:
        """List the inputs."""
        response.topics = self.inputs
        return response


def main() -> None:
    """Run until Ctrl-C."""
    words = remove_ros_args()[1:]
    given: list[Any] = []
    if words:
        given = [
            zbot.Parameter("output_topic", value=words[0]),
            zbot.Parameter("input_topics", value=words[1:]),
        ]
    run_node(lambda: Mux(parameter_overrides=given))


if __name__ == "__main__":
    main()
