"""Tests of the programs of tf2_ros in real processes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import Program

    Start = Callable[..., Program]

PUBLISHER = ("zbot", "run", "tf2_ros", "static_transform_publisher")
ECHO = ("zbot", "run", "tf2_ros", "tf2_echo")
FRAMES = ("--frame-id", "map", "--child-frame-id", "base")
PROGRAM = """
import zbot.compat
import rclpy
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, TransformException, TransformListener
import tf2_geometry_msgs


class Looker(Node):
    def __init__(self):
        super().__init__("looker")
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self, spin_thread=True)
        self.timer = self.create_timer(0.1, self.look)
        self.done = rclpy.Future()

    def look(self):
        try:
            seen = self.buffer.lookup_transform("map", "base", Time(), Duration(seconds=5))
        except TransformException as error:
            self.get_logger().info(str(error))
            return
        t = seen.transform.translation
        print("seen", t.x, t.y, t.z)
        self.done.set_result(None)


rclpy.init()
node = Looker()
rclpy.spin_until_future_complete(node, node.done)
rclpy.shutdown()
"""


def test_echo_shows_every_form_of_a_rotation(start: Start) -> None:
    start(*PUBLISHER, "--z", "0.5", "--qz", "0.7", "--qw", "0.7", *FRAMES).wait_for("from 'map'")
    echo = start(*ECHO, "map", "base", "10")
    echo.wait_for("At time 0.0")
    echo.wait_for("- Translation: [0.000, 0.000, 0.500]")
    echo.wait_for("- Rotation: in Quaternion (xyzw) [0.000, 0.000, 0.707, 0.707]")
    echo.wait_for("- Rotation: in RPY (radian) [0.000, 0.000, 1.571]")
    echo.wait_for("- Rotation: in RPY (degree) [0.000, 0.000, 90.000]")
    echo.wait_for("- Matrix:")
    assert echo.wait_for("1.000").split() == ["0.000", "-1.000", "0.000", "0.000"]


def test_a_program_written_for_ros2_looks_up_a_transform(start: Start) -> None:
    start(*PUBLISHER, "1", "2", "3", "0", "0", "0", "1", "map", "base").wait_for("from 'map'")
    program = start(source=PROGRAM)
    program.wait_for("seen 1.0 2.0 3.0")
    assert program.wait() == 0


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("--frame-id", "map", "--child-frame-id", "map"), "from 'map' to itself"),
        (("--qw", "0", *FRAMES), "are all 0"),
        (("--yaw", "1", "--qz", "1", *FRAMES), "not by both"),
        (("--x", "1"), "--frame-id"),
    ],
)
def test_invalid_arguments_are_refused(start: Start, words: tuple[str, ...], sentence: str) -> None:
    publisher = start(*PUBLISHER, *words)
    assert publisher.wait() == 2
    assert sentence in publisher.output


@pytest.mark.parametrize("rate", ["fast", "0"])
def test_an_invalid_rate_is_refused(start: Start, rate: str) -> None:
    echo = start(*ECHO, "map", "base", rate)
    assert echo.wait() == 1
    assert f"echo_rate must be a number above 0, not '{rate}'" in echo.output
