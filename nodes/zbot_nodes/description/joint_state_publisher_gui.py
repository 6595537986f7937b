"""Move the joints of a robot with sliders in the page.

Each joint that moves is a parameter `joints.NAME` of this node, with the joint's limits. The page
shows them as sliders in its panel Joints. `zbot param set` does the same in a terminal.

Run:        zbot run joint_state_publisher_gui joint_state_publisher_gui [robot.urdf]
Topics and other parameters: those of joint_state_publisher
Serves:     ~/center and ~/randomize (std_srvs/Empty), for the buttons of ROS 2's own window
"""

from __future__ import annotations

import random
from typing import TYPE_CHECKING, Any
from urllib.parse import quote

import zbot
from zbot.libraries.robot_description.joint_sliders import (
    ANGLE,
    CENTER,
    DISTANCE,
    PREFIX,
    RANDOMIZE,
)
from zbot.parameters.ros_args import remove_ros_args
from zbot_nodes.description.joint_state_publisher import JointStatePublisher
from zbot_nodes.startup.page import shown
from zbot_nodes.startup.program import run_node

from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor
from std_srvs.srv import Empty

if TYPE_CHECKING:
    from zbot_nodes.description.joint_values import JointValue


class JointStatePublisherGui(JointStatePublisher):
    """Publishes the positions of its sliders."""

    def __init__(self, path: str = "", **options: Any) -> None:
        super().__init__(path, **options)
        self.add_post_set_parameters_callback(self.follow)
        self.create_service(Empty, f"~/{CENTER}", self.center)
        self.create_service(Empty, f"~/{RANDOMIZE}", self.randomize)

    def configure(self, description: str) -> None:
        """Use a description, and make a slider for each joint that follows no other joint."""
        super().configure(description)
        free = self.joints.free if self.joints is not None else {}
        for name in list(self.get_parameters_by_prefix("joints")):
            if name not in free:
                self.undeclare_parameter(f"{PREFIX}{name}")
        for name, joint in free.items():
            self.add_slider(f"{PREFIX}{name}", joint)

    def add_slider(self, name: str, joint: JointValue) -> None:
        """Declare the parameter of a joint. Keep an existing value, within the joint's limits."""
        if self.has_parameter(name):
            known = float(self.get_parameter(name).value)
            joint.position = min(max(known, joint.lower), joint.upper)
            self.undeclare_parameter(name)
        limits = FloatingPointRange(from_value=joint.lower, to_value=joint.upper)
        start = joint.zero if joint.position is None else joint.position
        descriptor = ParameterDescriptor(
            description=ANGLE if joint.is_angle else DISTANCE, floating_point_range=[limits]
        )
        value = min(max(start, joint.lower), joint.upper)
        self.declare_parameter(name, value, descriptor, ignore_override=True)
        joint.position = value

    def follow(self, parameters: list[zbot.Parameter[Any]]) -> None:
        """Move the joints whose sliders were moved."""
        for parameter in parameters:
            name = parameter.name.removeprefix(PREFIX)
            if parameter.name.startswith(PREFIX) and self.joints and name in self.joints.free:
                self.joints.free[name].position = float(parameter.value)

    def center(self, _request: Empty.Request, response: Empty.Response) -> Empty.Response:
        """Move every slider to the joint's zero position."""
        self.move({name: joint.zero for name, joint in self.free().items()})
        return response

    def randomize(self, _request: Empty.Request, response: Empty.Response) -> Empty.Response:
        """Move every slider to a random position between the joint's limits."""
        self.move({name: random.uniform(o.lower, o.upper) for name, o in self.free().items()})
        return response

    def free(self) -> dict[str, JointValue]:
        """Return the joints that have a slider."""
        return self.joints.free if self.joints is not None else {}

    def move(self, positions: dict[str, float]) -> None:
        """Set the parameters of joints."""
        names = positions.items()
        self.set_parameters([zbot.Parameter(f"{PREFIX}{name}", value=at) for name, at in names])


def main() -> None:
    """Run until Ctrl-C."""
    paths = [word for word in remove_ros_args()[1:] if not word.startswith("-")]
    run_node(
        lambda: JointStatePublisherGui(paths[0] if paths else ""),
        around=lambda node: shown(
            node, f"/joints?node={quote(node.get_fully_qualified_name())}", "sliders"
        ),
    )


if __name__ == "__main__":
    main()
