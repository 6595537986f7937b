"""Connect images of the simulator with topics of ROS, as ros_gz_image does.

Run:       zbot run ros_gz_image image_bridge /camera/image_raw
Publishes: /simulation/connections (std_msgs/String): what the simulator shall connect
"""

from __future__ import annotations

from zbot.parameters.ros_args import remove_ros_args
from zbot_nodes.simulation.parameter_bridge import Bridge
from zbot_nodes.startup.program import run_node


def main() -> None:
    """Run until Ctrl-C."""
    words = [f"{topic}@sensor_msgs/msg/Image[gz.msgs.Image" for topic in remove_ros_args()[1:]]
    run_node(lambda: Bridge(words, "ros_gz_image"))


if __name__ == "__main__":
    main()
