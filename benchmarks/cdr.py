"""Compare the CDR codec with the MessagePack codec; print times and ratios for common types.

Run: python -m benchmarks.cdr
"""

from __future__ import annotations

import math
import sys
import time
from typing import TYPE_CHECKING, Any

import zbot  # noqa: F401 - makes the messages importable
from benchmarks.report import Report
from zbot.wire.cdr.codec import CdrCodec, cdr_codec_for
from zbot.wire.messagepack.codec import MessagePackCodec, messagepack_codec_for

from geometry_msgs.msg import PoseStamped, TransformStamped, Twist
from nav_msgs.msg import Odometry, Path
from sensor_msgs.msg import Image, Imu, JointState, LaserScan
from std_msgs.msg import Float32, Header, String, UInt8MultiArray
from tf2_msgs.msg import TFMessage

if TYPE_CHECKING:
    from collections.abc import Callable

# CPU time where its clock is exact: then other programs do not change the figures.
_clock = time.thread_time if sys.platform == "linux" else time.perf_counter
_ROUND_S = 0.01
_ROUNDS = 15
_HEADER = Header(frame_id="base_link")


def _joints(count: int) -> JointState:
    values = [0.1 * i for i in range(count)]
    names = [f"joint_{i}" for i in range(count)]
    return JointState(header=_HEADER, name=names, position=values, velocity=values, effort=values)


def _transforms(count: int) -> TFMessage:
    names = [f"link_{i}" for i in range(count)]
    return TFMessage(
        transforms=[TransformStamped(header=_HEADER, child_frame_id=name) for name in names]
    )


def _scan(count: int) -> LaserScan:
    values = [1.5] * count
    return LaserScan(header=_HEADER, ranges=values, intensities=values)


MESSAGES: dict[str, Any] = {
    "Float32": Float32(data=1.5),
    "String": String(data="Hello World: 1"),
    "Twist": Twist(),
    "Imu": Imu(header=_HEADER),
    "JointState 6": _joints(6),
    "JointState 12": _joints(12),
    "LaserScan 360": _scan(360),
    "LaserScan 720": _scan(720),
    "TFMessage 5": _transforms(5),
    "TFMessage 20": _transforms(20),
    "Odometry": Odometry(header=_HEADER, child_frame_id="base_footprint"),
    "PoseStamped": PoseStamped(header=_HEADER),
    "UInt8MultiArray 64": UInt8MultiArray(data=bytes(64)),
    "Path 50": Path(header=_HEADER, poses=[PoseStamped(header=_HEADER) for _ in range(50)]),
    "Image VGA": Image(
        header=_HEADER, height=480, width=640, encoding="rgb8", step=1920, data=bytes(921600)
    ),
}


def _seconds(function: Callable[[Any], Any], argument: Any, calls: int) -> float:
    begin = _clock()
    for _ in range(calls):
        function(argument)
    return (_clock() - begin) / calls


def fastest(functions: list[tuple[Callable[[Any], Any], Any]]) -> list[float]:
    """Return the shortest time of each call in seconds. The rounds of the functions alternate."""
    calls = [
        max(1, int(_ROUND_S / _seconds(function, argument, 3))) for function, argument in functions
    ]
    best = [math.inf] * len(functions)
    for _ in range(_ROUNDS):
        for index, (function, argument) in enumerate(functions):
            best[index] = min(best[index], _seconds(function, argument, calls[index]))
    return best


def compile_seconds(message: Any) -> float:
    """Return how long the encoder and the decoder of a type take to be generated and compiled."""
    codec: Any = CdrCodec(type(message))
    begin = _clock()
    codec.decode(codec.encode(message))
    return _clock() - begin


def table(report: Report) -> None:
    report.head(
        "ROS 2's encoding, CDR, beside zbot's own (microseconds, shortest of many rounds)",
        *("type", "encode CDR", "MessagePack", "ratio"),
        *("decode CDR", "MessagePack", "ratio", "compile CDR, ms"),
    )
    for name, message in MESSAGES.items():
        compiling = compile_seconds(message)
        cdr: CdrCodec[Any] = cdr_codec_for(type(message))
        own: MessagePackCodec[Any] = messagepack_codec_for(type(message))
        encode = fastest([(cdr.encode, message), (own.encode, message)])
        decode = fastest([(cdr.decode, cdr.encode(message)), (own.decode, own.encode(message))])
        cells = [
            text
            for theirs, ours in (encode, decode)
            for text in (f"{theirs * 1e6:.2f}", f"{ours * 1e6:.2f}", f"{theirs / ours:.2f}")
        ]
        report.row(name, *cells, f"{compiling * 1e3:.2f}")


if __name__ == "__main__":
    table(Report())
