"""Print the transform between two frames, once a second.

Run:        zbot run tf2_ros tf2_echo map base_link [RATE]
Subscribes: /tf and /tf_static (tf2_msgs/msg/TFMessage)
"""

import math
import sys
from typing import Any

import zbot
from zbot.parameters.ros_args import remove_ros_args
from zbot.tf2 import Buffer, TransformException
from zbot.tf2.diagnosis import TransformMonitor
from zbot.tf2.rigid import Quaternion, Vector, heading, rotate

_USAGE = """\
Usage: tf2_echo source_frame target_frame [echo_rate]

This prints where target_frame is, as seen from source_frame, echo_rate times a second.
The default of echo_rate is 1."""

_AXES: tuple[Vector, ...] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def angles(q: Quaternion) -> Vector:
    """Return roll, pitch and yaw in rad."""
    x, y, z, w = q
    roll = math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y))
    pitch = math.asin(max(-1.0, min(1.0, 2 * (w * y - z * x))))
    return (roll, pitch, heading(q))


def three(numbers: Vector) -> str:
    """Return three numbers as ROS 2's tf2_echo prints them."""
    return "[" + ", ".join(f"{number:.3f}" for number in numbers) + "]"


class TF2Echo(zbot.Node):
    """Looks up one transform periodically."""

    def __init__(self, source: str, target: str, rate: float) -> None:
        super().__init__("tf2_echo")
        self.source, self.target = source, target
        self.buffer = Buffer()
        self.monitor = TransformMonitor(self, self.buffer)
        # A robot may start while the time of a simulation stands still.
        real = zbot.Clock(clock_type=zbot.ClockType.STEADY_TIME)
        self.create_timer(1.0 / rate, self.print_transform, clock=real)

    def print_transform(self) -> None:
        """Print the transform, or the reason why there is none."""
        try:
            found = self.buffer.lookup_transform(self.source, self.target, zbot.Time())
        except TransformException as error:
            self.get_logger().info(
                f"Waiting for transform {self.source} ->  {self.target}: {error}"
                f"{self.monitor.explanation(self.source, self.target)}"
            )
        else:
            self.show(found)

    @staticmethod
    def show(found: Any) -> None:
        """Print one transform."""
        stamp, t, q = found.header.stamp, found.transform.translation, found.transform.rotation
        turn: Quaternion = (q.x, q.y, q.z, q.w)
        roll_pitch_yaw = angles(turn)
        roll, pitch, yaw = map(math.degrees, roll_pitch_yaw)
        columns = [rotate(turn, axis) for axis in _AXES]
        place: Vector = (t.x, t.y, t.z)
        print(f"At time {stamp.sec}.{stamp.nanosec}")
        print(f"- Translation: {three(place)}")
        print(f"- Rotation: in Quaternion (xyzw) [{q.x:.3f}, {q.y:.3f}, {q.z:.3f}, {q.w:.3f}]")
        print(f"- Rotation: in RPY (radian) {three(roll_pitch_yaw)}")
        print(f"- Rotation: in RPY (degree) {three((roll, pitch, yaw))}")
        print("- Matrix:")
        for row in range(3):
            numbers = (*(column[row] for column in columns), place[row])
            print("".join(f" {number:6.3f}" for number in numbers))
        print("  0.000  0.000  0.000  1.000", flush=True)


def main() -> None:
    """Run until Ctrl-C."""
    words = remove_ros_args()[1:]
    if len(words) not in {2, 3}:
        sys.exit(_USAGE)
    try:
        rate = float(words[2]) if len(words) == 3 else 1.0
    except ValueError:
        rate = 0.0
    if rate <= 0:
        sys.exit(f"echo_rate must be a number above 0, not {words[2]!r}")
    with zbot.init():
        zbot.spin(TF2Echo(words[0], words[1], rate))


if __name__ == "__main__":
    main()
