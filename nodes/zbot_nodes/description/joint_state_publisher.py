"""Publish joint states of a robot that has no sensors for its joints.

Run:        zbot run joint_state_publisher joint_state_publisher [robot.urdf]
Subscribes: robot_description (std_msgs/String); the topics of source_list (sensor_msgs/JointState)
Publishes:  joint_states (sensor_msgs/JointState)
Parameters: rate (10 Hz), publish_default_positions (true), publish_default_velocities (false),
            publish_default_efforts (false), use_mimic_tags (true), use_smallest_joint_limits
            (true), source_list ([]), delta (0.0: how far joints move in each message),
            zeros.JOINT, dependent_joints.JOINT.parent, .factor and .offset
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import zbot
from zbot.libraries.robot_description.urdf import Mimic, read_urdf
from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot.parameters.ros_args import remove_ros_args
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot_nodes.description.joint_values import Defaults, JointValues
from zbot_nodes.startup.program import run_node

from rcl_interfaces.msg import ParameterDescriptor
from sensor_msgs.msg import JointState
from std_msgs.msg import String

_DEPENDENT = ("parent", "factor", "offset")


class JointStatePublisher(zbot.Node):
    """Publishes values for every joint that moves.

    Args:
        path: Path of a URDF file. If the path is an empty string, the description comes from the
            topic.
        options: The options of `zbot.Node`.
    """

    def __init__(self, path: str = "", **options: Any) -> None:
        super().__init__(
            "joint_state_publisher",
            automatically_declare_parameters_from_overrides=True,
            **options,
        )
        self.defaults = Defaults(
            self.setting("publish_default_positions", True),
            self.setting("publish_default_velocities", False),
            self.setting("publish_default_efforts", False),
            self.setting("use_mimic_tags", True),
            self.setting("use_smallest_joint_limits", True),
        )
        rate_hz = float(self.setting("rate", 10))
        if rate_hz <= 0:
            raise DescriptionError("the parameter rate must be above 0")
        self.setting("delta", 0.0)
        self.joints: JointValues | None = None
        self.publisher = self.create_publisher(JointState, "joint_states", 10)
        for topic in self.setting("source_list", None):
            self.create_subscription(JointState, topic, self.take, 10)
        if path:
            self.configure(read_file(path))
        else:
            self.get_logger().info(
                "Waiting for robot_description to be published on the robot_description topic..."
            )
        kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.create_subscription(String, "robot_description", self.accept, kept)
        self.create_timer(1 / rate_hz, self.publish)

    def setting(self, name: str, default: Any) -> Any:
        """Declare a parameter unless it was set at the start, and return its value.

        If `default` is `None`, the default value is an empty list.
        """
        if not self.has_parameter(name):
            # Without dynamic typing, the default `[]` would make the parameter a byte array.
            any_type = ParameterDescriptor(dynamic_typing=default is None)
            self.declare_parameter(name, [] if default is None else default, any_type)
        return self.get_parameter(name).value

    def accept(self, message: String) -> None:
        """Use a description from the topic."""
        try:
            self.configure(message.data)
        except DescriptionError as error:
            self.get_logger().warn(str(error))

    def configure(self, description: str) -> None:
        """Use a description."""
        self.joints = JointValues(
            read_urdf(description), self.defaults, self.zeros(), self.dependent()
        )

    def zeros(self) -> dict[str, float]:
        """Return the start positions that the parameters `zeros` set."""
        found = self.get_parameters_by_prefix("zeros")
        return {name: float(parameter.value) for name, parameter in found.items()}

    def dependent(self) -> dict[str, Mimic]:
        """Return the rules of joints that the parameters `dependent_joints` set."""
        rules: dict[str, dict[str, Any]] = {}
        for name, parameter in self.get_parameters_by_prefix("dependent_joints").items():
            joint, _, key = name.rpartition(".")
            if not joint or key not in _DEPENDENT:
                raise DescriptionError(
                    f"the parameter dependent_joints.{name} must end with .parent, .factor or "
                    ".offset"
                )
            rules.setdefault(joint, {})[key] = parameter.value
        for joint, rule in rules.items():
            if not rule.get("parent"):
                raise DescriptionError(f"the parameter dependent_joints.{joint}.parent is missing")
        return {
            joint: Mimic(
                str(rule["parent"]), float(rule.get("factor", 1)), float(rule.get("offset", 0))
            )
            for joint, rule in rules.items()
        }

    def take(self, message: JointState) -> None:
        """Use the values in a message of a source."""
        if self.joints is not None:
            self.joints.take(message)

    def publish(self) -> None:
        """Publish the present values."""
        if self.joints is None or not self.joints.names:
            return
        delta = float(self.get_parameter("delta").value)
        if delta > 0:
            self.joints.advance(delta)
        message = JointState()
        message.header.stamp = self.get_clock().now().to_msg()
        self.joints.fill(message)
        self.publisher.publish(message)


def read_file(path: str) -> str:
    """Return the text of the URDF file of the command line."""
    try:
        return Path(path).read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise DescriptionError(f"cannot read '{path}': {error.strerror}") from None


def main() -> None:
    """Run until Ctrl-C."""
    paths = remove_ros_args()[1:]
    run_node(lambda: JointStatePublisher(paths[0] if paths else ""))


if __name__ == "__main__":
    main()
