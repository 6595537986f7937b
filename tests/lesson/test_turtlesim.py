"""The tutorial part of a first lesson, from its first line to its last, in one sitting.

Nodes, topics and the graph with turtlesim: three terminals, the commands in their order with `zbot`
for `ros2`, the arrow keys pressed in a real terminal, and the numbers that the turtle has to reach.
"""

from __future__ import annotations

import os
import sys
import threading
from typing import TYPE_CHECKING

import pytest

import zbot as zbot_api
from tests.cli.command import zbot
from tests.conftest import Program, allowed, wait_until

from turtlesim.msg import Pose

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from tests.conftest import Start

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs a pseudo-terminal")

UP, LEFT = b"\x1b[A", b"\x1b[D"
TWIST = "{linear: {x: 2.0, y: 0.0, z: 0.0}, angular: {x: 0.0, y: 0.0, z: 1.8}}"
PUB = ("topic", "pub", "--once", "/turtle1/cmd_vel", "geometry_msgs/msg/Twist", TWIST)
CENTRE = 5.544445
#: What a command of 1 s comes to, after 62 or after 63 ticks of 16 ms.
ONE_SECOND = (62 * 0.016, 63 * 0.016)

NODE_INFO = """\
/turtlesim
  Subscribers:
    /parameter_events: rcl_interfaces/msg/ParameterEvent
    /turtle1/cmd_vel: geometry_msgs/msg/Twist
  Publishers:
    /parameter_events: rcl_interfaces/msg/ParameterEvent
    /rosout: rcl_interfaces/msg/Log
    /turtle1/color_sensor: turtlesim/msg/Color
    /turtle1/pose: turtlesim/msg/Pose
  Service Servers:
    /clear: std_srvs/srv/Empty
    /kill: turtlesim/srv/Kill
    /reset: std_srvs/srv/Empty
    /spawn: turtlesim/srv/Spawn
    /turtle1/set_pen: turtlesim/srv/SetPen
    /turtle1/teleport_absolute: turtlesim/srv/TeleportAbsolute
    /turtle1/teleport_relative: turtlesim/srv/TeleportRelative
    /turtlesim/describe_parameters: rcl_interfaces/srv/DescribeParameters
    /turtlesim/get_parameter_types: rcl_interfaces/srv/GetParameterTypes
    /turtlesim/get_parameters: rcl_interfaces/srv/GetParameters
    /turtlesim/list_parameters: rcl_interfaces/srv/ListParameters
    /turtlesim/set_parameters: rcl_interfaces/srv/SetParameters
    /turtlesim/set_parameters_atomically: rcl_interfaces/srv/SetParametersAtomically
  Service Clients:

  Action Servers:
    /turtle1/rotate_absolute: turtlesim/action/RotateAbsolute
  Action Clients:
"""

TOPICS_WITH_TYPES = """\
/parameter_events [rcl_interfaces/msg/ParameterEvent]
/rosout [rcl_interfaces/msg/Log]
/turtle1/cmd_vel [geometry_msgs/msg/Twist]
/turtle1/color_sensor [turtlesim/msg/Color]
/turtle1/pose [turtlesim/msg/Pose]
"""


class Terminal(Program):
    """A program with a keyboard."""

    def __init__(self, command: list[str], cwd: Path) -> None:
        import pty  # noqa: PLC0415 - there is none on Windows

        self._keyboard, screen = pty.openpty()
        super().__init__(command, cwd, dict(os.environ), stdin=screen)
        os.close(screen)

    def press(self, key: bytes) -> None:
        os.write(self._keyboard, key)

    def close(self) -> None:
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait(5)
        os.close(self._keyboard)


@pytest.fixture
def turtlesim(start: Start) -> Program:
    program = start("zbot", "run", "turtlesim", "turtlesim_node")
    program.wait_for("[INFO]")
    program.wait_for("Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]")
    assert "Starting turtlesim with node name /turtlesim" in program.lines[0]
    return program


@pytest.fixture
def teleop(turtlesim: Program, tmp_path: Path) -> Iterator[Terminal]:
    assert turtlesim.process.poll() is None
    words = [sys.executable, "-m", "zbot_cli", "run", "turtlesim", "turtle_teleop_key"]
    terminal = Terminal(words, tmp_path)
    for line in ("Reading from keyboard", "Use arrow keys to move the turtle.", "'Q' to quit."):
        terminal.wait_for(line)
    yield terminal
    terminal.close()


def out(*words: str) -> str:
    done = zbot(*words)
    assert (done.code, done.err) == (0, ""), done
    return done.out


class Poses:
    """What a turtle tells of itself."""

    def __init__(self, node: zbot_api.Node) -> None:
        self.node = node
        self._last = Pose()
        self._has_moved = False
        self._is_at_rest = threading.Event()
        node.create_subscription(Pose, "/turtle1/pose", self._look, 10)

    def _look(self, pose: Pose) -> None:
        moves = pose.linear_velocity != 0 or pose.angular_velocity != 0
        if self._has_moved and not moves:
            self._last = pose
            self._is_at_rest.set()
        self._has_moved = moves

    def after(self, act: Callable[[], object]) -> Pose:
        """Do something that moves the turtle for a while; return where that ends."""
        self._is_at_rest.clear()
        act()
        assert self._is_at_rest.wait(allowed(30)), "the turtle did not move, or did not stop"
        return self._last


@pytest.fixture
def poses(
    turtlesim: Program, make_context: Callable[[], zbot_api.Context], spin: Callable[..., object]
) -> Poses:
    assert turtlesim.process.poll() is None
    node = zbot_api.Node("_watcher", context=make_context())
    found = Poses(node)
    spin(node)
    assert node.wait_for_node("turtlesim", allowed(15))
    return found


def test_nodes_topics_and_the_graph(
    start: Start, turtlesim: Program, teleop: Terminal, poses: Poses
) -> None:
    # 2.2 Nodes
    assert out("node", "list") == "/teleop_turtle\n/turtlesim\n"
    assert out("node", "info", "/turtlesim").rstrip("\n") == NODE_INFO.rstrip("\n")
    assert "/turtle1/cmd_vel: geometry_msgs/msg/Twist" in out("node", "info", "/teleop_turtle")

    # 2.3 Topics
    names = "".join(f"{line.split()[0]}\n" for line in TOPICS_WITH_TYPES.splitlines())
    assert out("topic", "list") == names
    assert out("topic", "list", "-t") == TOPICS_WITH_TYPES
    assert out("topic", "info", "/turtle1/cmd_vel") == (
        "Type: geometry_msgs/msg/Twist\nPublisher count: 1\nSubscription count: 1\n"
    )
    assert "Vector3  linear\n\tfloat64 x" in out("interface", "show", "geometry_msgs/msg/Twist")

    echo = start("zbot", "topic", "echo", "/turtle1/cmd_vel")
    assert wait_until(lambda: poses.node.count_subscribers("/turtle1/cmd_vel") == 2)
    driven = poses.after(lambda: teleop.press(UP)).x
    echo.wait_for("x: 2.0")
    assert any(driven == pytest.approx(CENTRE + 2 * time, abs=1e-4) for time in ONE_SECOND)
    turned = poses.after(lambda: teleop.press(LEFT)).theta
    echo.wait_for("z: 2.0")
    assert any(turned == pytest.approx(2 * time, abs=1e-4) for time in ONE_SECOND)

    out("service", "call", "/reset", "std_srvs/srv/Empty")
    turtlesim.wait_for("Spawning turtle [turtle1]")
    reached = poses.after(lambda: out(*PUB))
    assert (reached.x, reached.y, reached.theta) in (
        pytest.approx((6.6105, 6.9079, 1.7856), abs=1e-4),
        pytest.approx((6.6028, 6.9390, 1.8144), abs=1e-4),
    )
    echo.wait_for("z: 1.8")

    always = start("zbot", "topic", "pub", "--rate", "1", *PUB[3:])
    always.wait_for("publishing #2")
    start("zbot", "topic", "hz", "/turtle1/pose").wait_for_rate(62.5, within_hz=6)

    start("zbot", "topic", "hz", "/turtle1/cmd_vel").wait_for_rate(1, within_hz=0.2)
    always.stop()

    # 2.4 The graph
    assert "/teleop_turtle -> [/turtle1/cmd_vel] -> /turtlesim\n" in out("graph")
    drawn = out("graph", "--dot")
    for edge in (
        '"n:/teleop_turtle" -> "t:/turtle1/cmd_vel"',
        '"t:/turtle1/cmd_vel" -> "n:/turtlesim"',
    ):
        assert edge in drawn

    teleop.press(b"q")
    assert teleop.wait() == 0
    assert turtlesim.stop() == -2
    for program in (turtlesim, teleop, echo, always):
        assert "Traceback" not in program.output


def test_the_wall_is_told_of(turtlesim: Program, teleop: Terminal, poses: Poses) -> None:
    poses.after(lambda: teleop.press(UP))
    poses.after(lambda: teleop.press(UP))
    reached = poses.after(lambda: teleop.press(UP))
    assert reached.x == pytest.approx(11.088889)
    turtlesim.wait_for("Oh no! I hit the wall! (Clamping from [x=11.112445, y=5.544445])")


def test_two_simulators_in_two_namespaces(start: Start) -> None:
    launched = start("zbot", "launch", "turtlesim", "multisim.launch.py")
    launched.wait_for("Spawning turtle [turtle1]")
    launched.wait_for("Spawning turtle [turtle1]")
    assert out("node", "list") == "/turtlesim1/turtlesim\n/turtlesim2/turtlesim\n"
    assert "/turtlesim2/turtle1/cmd_vel [geometry_msgs/msg/Twist]" in out("topic", "list", "-t")
    out("service", "call", "/turtlesim1/spawn", "turtlesim/srv/Spawn", "{x: 1, y: 1, name: eve}")
    topics = out("topic", "list").split()
    assert "/turtlesim1/eve/pose" in topics
    assert "/turtlesim2/eve/pose" not in topics
    assert launched.stop(timeout=10) == 0
