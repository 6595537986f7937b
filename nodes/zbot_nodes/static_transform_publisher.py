"""Publish one transform that does not change, and run until Ctrl-C.

Run:       zbot run tf2_ros static_transform_publisher --x 0.1 --yaw 1.57 \
               --frame-id base_link --child-frame-id laser
Publishes: /tf_static (tf2_msgs/msg/TFMessage), kept for late subscribers
"""

import argparse
import math
import os

import zbot
from zbot.parameters.ros_args import remove_ros_args
from zbot.tf2 import StaticTransformBroadcaster
from zbot.tf2.rigid import Quaternion, multiply, normalized

from geometry_msgs.msg import TransformStamped

# Numbers of words in ROS 1's order: 8 with yaw, pitch and roll; 9 with qx, qy, qz and qw.
_OLD_STYLE = (8, 9)


def read_arguments(words: list[str]) -> argparse.Namespace:
    """Read the command line. It has options, or only values in ROS 1's order."""
    parser = argparse.ArgumentParser(prog="static_transform_publisher")
    for name in ("x", "y", "z", "roll", "pitch", "yaw", "qx", "qy", "qz"):
        parser.add_argument(f"--{name}", type=float, default=0.0)
    parser.add_argument("--qw", type=float, default=1.0)
    parser.add_argument("--frame-id", required=True, help="the parent frame's name")
    parser.add_argument("--child-frame-id", required=True, help="the child frame's name")
    if len(words) in _OLD_STYLE and not any(word.startswith("--") for word in words):
        turn = ("yaw", "pitch", "roll") if len(words) == _OLD_STYLE[0] else ("qx", "qy", "qz", "qw")
        names = ("x", "y", "z", *turn, "frame-id", "child-frame-id")
        words = [f"--{name}={word}" for name, word in zip(names, words, strict=True)]
    options = parser.parse_args(words)
    problem = _problem(options)
    if problem:
        parser.error(problem)
    return options


def _problem(options: argparse.Namespace) -> str:
    """Return the reason why the options are not valid, or an empty string."""
    if options.frame_id.strip("/") == options.child_frame_id.strip("/"):
        return f"cannot publish a transform from {options.frame_id!r} to itself"
    numbers = (options.qx, options.qy, options.qz, options.qw)
    if math.hypot(*numbers) == 0:
        return "--qx, --qy, --qz and --qw are all 0: leave them out for no rotation"
    if numbers != (0, 0, 0, 1) and (options.roll or options.pitch or options.yaw):
        return "give the rotation by --roll, --pitch and --yaw, or by --qx to --qw, not by both"
    return ""


def rotation(options: argparse.Namespace) -> Quaternion:
    """Return the rotation as a quaternion. The options give angles in rad or a quaternion."""
    roll, pitch, yaw = options.roll / 2, options.pitch / 2, options.yaw / 2
    if not (roll or pitch or yaw):
        # Listeners ignore a quaternion whose length is not 1, such as (0, 0, 0.7, 0.7).
        return normalized((options.qx, options.qy, options.qz, options.qw))
    about_x: Quaternion = (math.sin(roll), 0.0, 0.0, math.cos(roll))
    about_y: Quaternion = (0.0, math.sin(pitch), 0.0, math.cos(pitch))
    about_z: Quaternion = (0.0, 0.0, math.sin(yaw), math.cos(yaw))
    return multiply(about_z, multiply(about_y, about_x))


class StaticTransformPublisher(zbot.Node):
    """Publishes one transform, once."""

    def __init__(self, options: argparse.Namespace) -> None:
        # Often several publishers run at the same time, so each publisher gets its own name.
        super().__init__(f"static_transform_publisher_{os.getpid()}")
        message = TransformStamped(child_frame_id=options.child_frame_id)
        message.header.frame_id = options.frame_id
        message.header.stamp = self.get_clock().now().to_msg()
        t, q = message.transform.translation, message.transform.rotation
        t.x, t.y, t.z = options.x, options.y, options.z
        q.x, q.y, q.z, q.w = rotation(options)
        self.broadcaster = StaticTransformBroadcaster(self)
        self.broadcaster.sendTransform(message)
        self.get_logger().info(
            "Spinning until stopped - publishing transform\n"
            f"translation: ('{t.x:f}', '{t.y:f}', '{t.z:f}')\n"
            f"rotation: ('{q.x:f}', '{q.y:f}', '{q.z:f}', '{q.w:f}')\n"
            f"from '{options.frame_id}' to '{options.child_frame_id}'"
        )


def main() -> None:
    """Run until Ctrl-C."""
    options = read_arguments(remove_ros_args()[1:])
    with zbot.init():
        zbot.spin(StaticTransformPublisher(options))


if __name__ == "__main__":
    main()
