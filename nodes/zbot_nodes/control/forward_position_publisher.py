"""Publish positions for a controller that forwards them to joints.

Run:        zbot run ros2_controllers_test_nodes publisher_forward_position_controller
            --ros-args --params-file goals.yaml
Publishes:  the topic of the parameter publish_topic (std_msgs/Float64MultiArray)
Parameters: publish_topic (/position_commands), wait_sec_between_publish (5), goal_names;
            for each goal a parameter with its name: the positions of the joints
"""

from __future__ import annotations

from typing import Any

from zbot_nodes.control.goal_publisher import GoalPublisher
from zbot_nodes.startup.program import ParameterError, run_node

from std_msgs.msg import Float64MultiArray


class ForwardPositionPublisher(GoalPublisher):
    """Publishes the positions of one goal after the other."""

    def __init__(self, **options: Any) -> None:
        super().__init__("publisher_forward_position_controller", **options)

    def topic(self) -> str:
        """Return the name of the topic."""
        return str(self.read("publish_topic", "/position_commands"))

    def message(self, goal: str) -> Float64MultiArray:
        """Return the positions of a goal."""
        positions = self.numbers(goal)
        if not positions:
            raise ParameterError(
                f"the parameter {goal} is empty: write the positions of the joints"
            )
        return Float64MultiArray(data=positions)


def main() -> None:
    """Run until Ctrl-C."""
    run_node(ForwardPositionPublisher)


if __name__ == "__main__":
    main()
