"""Nodes, bags and commands for the tests of `zbot bag`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tests.conftest import wait_until
from zbot.bag import Writer
from zbot.qos import DurabilityPolicy, QoSProfile

from sensor_msgs.msg import LaserScan
from std_msgs.msg import Header, String

if TYPE_CHECKING:
    from pathlib import Path

    import zbot as library
    from tests.conftest import Program, Start

Heard = list[tuple[str, str, float]]  #: topic, text and time of each message
LATCHED = QoSProfile(depth=2, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class Robot:
    """Node that publishes on /chatter and /scan at 50 Hz, and latched on /map."""

    def __init__(self, node: library.Node) -> None:
        self.node = node
        self.count = 0
        self.chatter = node.create_publisher(String, "chatter", 10)
        self.scan = node.create_publisher(LaserScan, "scan", 10)
        self.map = node.create_publisher(String, "map", LATCHED)
        self.map.publish(String(data="room"))
        node.create_timer(0.02, self.speak)

    def speak(self) -> None:
        self.count += 1
        self.chatter.publish(String(data=str(self.count)))
        self.scan.publish(LaserScan(header=Header(frame_id="laser"), ranges=[1.0, 2.0]))


def recording(start: Start, *words: str) -> Program:
    program = start("zbot", "bag", "record", "-o", "lesson", *words)
    program.wait_for("Recording...")
    return program


def size(path: Path) -> int:
    return sum(file.stat().st_size for file in path.glob("*.mcap"))


def grow(path: Path) -> None:
    """Wait until more messages are in the file."""
    before = size(path)
    assert wait_until(lambda: size(path) > before + 200)


def make_bag(path: Path, *messages: tuple[str, Any, float]) -> Path:
    """Write messages with their topics and times in seconds."""
    with Writer(path) as bag:
        for topic, message, time_s in messages:
            bag.write(topic, message, int(time_s * 1e9))
    return path


def words_of(heard: list[tuple[str, str, float]]) -> list[tuple[str, str]]:
    return [(topic, text) for topic, text, _ in heard]


def text_bag(path: Path, *texts: str, topic: str = "/a", step_s: float = 0.1) -> Path:
    """Write texts to a topic with a time between them."""
    lines = [(topic, String(data=text), 100 + n * step_s) for n, text in enumerate(texts)]
    return make_bag(path, *lines)
