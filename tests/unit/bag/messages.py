"""Messages of the tests of bags, and functions that write and read them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import zbot.bag
from zbot.bag import Writer
from zbot.qos import DurabilityPolicy, QoSProfile

from builtin_interfaces.msg import Time
from geometry_msgs.msg import PoseStamped, TwistStamped
from sensor_msgs.msg import Image, LaserScan
from std_msgs.msg import Float64, Header, String
from test_msgs.msg import Arrays, BasicTypes, Constants, Nested, UnboundedSequences
from tf2_msgs.msg import TFMessage

if TYPE_CHECKING:
    from pathlib import Path

LATCHED = QoSProfile(depth=3, durability=DurabilityPolicy.TRANSIENT_LOCAL)
HEADER = Header(stamp=Time(sec=5, nanosec=6), frame_id="böx")
MESSAGES: list[Any] = [
    String(data="hello"),
    Float64(data=1.5),
    TwistStamped(header=HEADER),
    PoseStamped(header=HEADER),
    LaserScan(header=HEADER, ranges=[1.0, 2.0], intensities=[3.0]),
    Image(header=HEADER, height=2, width=2, step=2, data=[1, 2, 3, 4]),
    Nested(basic_types_value=BasicTypes(int64_value=-5, bool_value=True)),
    Arrays(string_values=["a", "bb", "ccc"], float32_values=[1.0, 2.0, 3.0]),
    UnboundedSequences(int16_values=[1, -2], string_values=["x", ""]),
    Constants(),
    TFMessage(),
]
# rosbags computes another hash for types with `char` than ROS 2 does, and refuses them.
WITHOUT_CHAR = [*MESSAGES[:6], TFMessage()]


def write(path: Path, messages: list[Any], **options: Any) -> Path:
    """Write messages to a topic of their type each, one millisecond apart."""
    with Writer(path, **options) as bag:
        for number, message in enumerate(messages):
            bag.write(f"/{type(message).__name__.lower()}", message, 1_000_000 * number)
    return path


def names_and_messages(path: Path) -> list[tuple[str, Any]]:
    return [(topic, message) for topic, message, _ in zbot.bag.read(path)]


def expected(messages: list[Any]) -> list[tuple[str, Any]]:
    return [(f"/{type(message).__name__.lower()}", message) for message in messages]
