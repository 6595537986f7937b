"""Connect topics of the simulator with topics of ROS, as ros_gz_bridge does.

Run:        zbot run ros_gz_bridge parameter_bridge /imu@sensor_msgs/msg/Imu[gz.msgs.IMU
            zbot run ros_gz_bridge parameter_bridge --ros-args -p config_file:=bridge.yaml
Publishes:  /simulation/connections (std_msgs/String): what the simulator shall connect
Parameters: config_file: a file in YAML with the connections

The simulator publishes and subscribes itself, so no message passes through this program. The signs
between the types give the direction: `[` to ROS, `]` to the simulator, and `@` both.
"""

from __future__ import annotations

import json
import os
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

import zbot
from zbot.parameters.ros_args import remove_ros_args
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.simulation.node.ports import BOTH, CONNECTIONS_TOPIC, TO_GAZEBO, TO_ROS
from zbot.text.yaml_reader import YamlError, read_yaml
from zbot_nodes.startup.program import ParameterError, run_node

from std_msgs.msg import String

if TYPE_CHECKING:
    from collections.abc import Iterable

_KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
_WORD = re.compile(r"(?P<topic>[^@\[\]]+)@(?P<type>[^@\[\]]+)(?P<sign>[@\[\]])(?P<gz>[^@\[\]]+)")
_SIGNS = {"@": BOTH, "[": TO_ROS, "]": TO_GAZEBO}
_DIRECTIONS = {"BIDIRECTIONAL": BOTH, "GZ_TO_ROS": TO_ROS, "ROS_TO_GZ": TO_GAZEBO}
#: Topic of Gazebo, topic of ROS, type, direction.
Row = tuple[str, str, str, str]


class Bridge(zbot.Node):
    """Node that says what the simulator shall connect."""

    def __init__(self, words: Iterable[str], name: str = "ros_gz_bridge", **options: Any) -> None:
        super().__init__(name, **options)
        self.declare_parameter("config_file", "")
        rows = [row for word in words for row in self.row_of(word)]
        file = str(self.get_parameter("config_file").value)
        if file:
            rows += read_file(file)
        if not rows:
            self.get_logger().warning("There is nothing to connect")
        connections = [
            (f"/{gazebo.strip('/')}", self.resolve_topic_name(ros), kind, direction)
            for gazebo, ros, kind, direction in rows
        ]
        publisher = self.create_publisher(String, CONNECTIONS_TOPIC, _KEPT)
        name = self.get_fully_qualified_name()
        publisher.publish(String(data=f"{name} {os.getpid()}\n{json.dumps(connections)}"))
        for gazebo, ros, kind, direction in connections:
            self.get_logger().info(f"Connecting [{gazebo}] with [{ros}] ({kind}), {direction}")

    def row_of(self, word: str) -> list[Row]:
        """Return the connection that a word of the command line describes."""
        found = _WORD.fullmatch(word)
        if found is not None:
            topic = found["topic"]
            return [(topic, topic, found["type"], _SIGNS[found["sign"]])]
        if "/srv/" not in word:  # the simulator serves the services itself
            self.get_logger().warning(f"'{word}' is not TOPIC@ROS_TYPE[GZ_TYPE: it is left out")
        return []


def read_file(path: str) -> list[Row]:
    """Return the connections in a file of ros_gz_bridge.

    Raises:
        ParameterError: The file cannot be read, or is not such a file.
    """
    try:
        entries = read_yaml(Path(path).read_text("utf-8"))
    except (OSError, UnicodeDecodeError, YamlError) as error:
        raise ParameterError(f"the file {path} of config_file cannot be read: {error}") from error
    if not isinstance(entries, list) or not all(isinstance(entry, dict) for entry in entries):
        raise ParameterError(f"the file {path} of config_file is not a list of connections")
    return [row for entry in entries if (row := _row(entry, path))]


def _row(entry: dict[str, Any], path: str) -> Row | None:
    if "service_name" in entry:
        return None  # the simulator serves the services itself
    both = entry.get("topic_name", "")
    ros = entry.get("ros_topic_name", both) or entry.get("gz_topic_name", "")
    gazebo = entry.get("gz_topic_name", entry.get("ign_topic_name", both)) or ros
    direction = _DIRECTIONS.get(str(entry.get("direction", "BIDIRECTIONAL")).upper())
    if not ros or direction is None:
        raise ParameterError(f"the file {path} has a connection without a topic or direction")
    return str(gazebo), str(ros), str(entry.get("ros_type_name", "")), direction


def main() -> None:
    """Run until Ctrl-C."""
    run_node(lambda: Bridge(remove_ros_args()[1:]))


if __name__ == "__main__":
    main()
