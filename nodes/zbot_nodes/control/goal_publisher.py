"""Base class of nodes that publish goals for a controller, one after the other, without end."""

from __future__ import annotations

from itertools import cycle
from typing import Any

import zbot
from zbot_nodes.startup.program import ParameterError

from rcl_interfaces.msg import ParameterDescriptor


class GoalPublisher(zbot.Node):
    """Publishes a message for each goal in the parameter `goal_names`.

    Args:
        name: The name of the node.
        options: The options of `zbot.Node`.

    Raises:
        ParameterError: A parameter cannot be used.
    """

    period_s = 5  #: the default of `wait_sec_between_publish`

    def __init__(self, name: str, **options: Any) -> None:
        super().__init__(name, **options)
        period_s = self.read("wait_sec_between_publish", self.period_s)
        if isinstance(period_s, bool) or not isinstance(period_s, (int, float)) or period_s <= 0:
            raise ParameterError("the parameter wait_sec_between_publish must be above 0")
        names = self.declare_parameter("goal_names", ["pos1", "pos2"]).value
        messages = [self.message(goal) for goal in names]
        if not messages:
            raise ParameterError("the parameter goal_names is empty")
        topic = self.topic()
        self.publisher = self.create_publisher(type(messages[0]), topic, 1)
        self.messages = cycle(messages)
        self.get_logger().info(
            f"Publishing {len(messages)} goals on topic '{topic}' every {period_s} s"
        )
        self.create_timer(period_s, self.publish)

    def read(self, name: str, default: Any = None) -> Any:
        """Declare a parameter of any type, and return its value."""
        if not self.has_parameter(name):
            self.declare_parameter(name, default, ParameterDescriptor(dynamic_typing=True))
        return self.get_parameter(name).value

    def numbers(self, name: str) -> list[float]:
        """Return a parameter with numbers. It is empty if it is not set."""
        value = self.read(name)
        if value is None:
            return []
        try:
            return [float(number) for number in value]
        except (TypeError, ValueError):
            raise ParameterError(f"the parameter {name} must be a list of numbers") from None

    def topic(self) -> str:
        """Return the name of the controller's topic."""
        raise NotImplementedError

    def message(self, goal: str) -> Any:
        """Return the message of a goal."""
        raise NotImplementedError

    def publish(self) -> None:
        """Publish the next goal."""
        message = next(self.messages)
        self.get_logger().info(f"Publishing: {message}")
        self.publisher.publish(message)
