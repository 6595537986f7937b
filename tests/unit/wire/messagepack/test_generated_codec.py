"""Tests of the generated encoders and decoders: they do the same as the walker."""

from __future__ import annotations

import math
import sys
import threading
from dataclasses import dataclass
from random import Random
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from moveit_msgs.msg import PlanningScene

import zbot  # noqa: F401 - makes the messages importable
from tests.unit.wire.messagepack.coded import packb
from tests.unit.wire.random_message import message_of, random_message, shipped_messages
from zbot.interfaces import get_interface, get_message, message_spec_of, register_spec
from zbot.interfaces.parser import parse_message
from zbot.wire.errors import CodecError
from zbot.wire.messagepack import generated_codec
from zbot.wire.messagepack.codec import messagepack_codec_for
from zbot.wire.messagepack.walker import Walker

from builtin_interfaces.msg import Time
from geometry_msgs.msg import PoseStamped, TransformStamped
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import Image, Imu, JointState, LaserScan
from std_msgs.msg import Byte, ByteMultiArray, Float32, Float64, Header, Int64, String, UInt8
from test_msgs.msg import MultiNested
from tf2_msgs.msg import TFMessage

TYPES = shipped_messages()
NOW = Header(stamp=Time(sec=1_700_000_000, nanosec=999_999_999), frame_id="odom")


@dataclass
class Pair:
    a: int = 0


@dataclass
class Reading:
    name: str
    count: int
    ratio: float
    is_valid: bool
    blob: bytes
    values: list[float]
    counts: list[int]
    texts: list[str]
    pairs: list[Pair]


USUAL = [
    Imu(header=NOW),
    JointState(header=NOW, name=["a", "b" * 40], position=[1.0, 2.0]),
    JointState(header=NOW, name=[f"joint_{number}" for number in range(100)], effort=[1.0]),
    JointState(header=NOW, name=["long" * number for number in range(100)], effort=[1.0]),
    Clock(clock=Time(sec=60_000, nanosec=500_000_000)),
    LaserScan(header=NOW, ranges=[1.0] * 2000, range_max=math.inf, angle_min=math.nan),
    Image(header=NOW, encoding="rgb8", data=bytes(70_000)),
    TFMessage(transforms=[TransformStamped(header=NOW)] * 20),
    Header(),
    String(data="x" * 100_000),
    Int64(data=-(2**63)),
    Byte(data=b"\xff"),
    ByteMultiArray(data=[b"\0", b"\xff"]),
    MultiNested(),
    PlanningScene(name="kitchen"),
    Reading("a", 2, 0.5, False, b"\1\2", [1.0, 2.0], [3, 4], ["x"], [Pair(1), Pair(2)]),
]


def fail(_: Any) -> Any:
    pytest.fail("the walker was called")


def fast(message_class: type[Any]) -> tuple[Any, Any]:
    return generated_codec.encoder(message_class, fail), generated_codec.decoder(
        message_class, fail
    )


def sent(encode: Any, message: Any) -> Any:
    try:
        return encode(message)
    except CodecError as error:
        return str(error)


def outcome(decode: Any, data: bytes) -> Any:
    try:
        return Walker(type(message := decode(data))).encode(message)
    except CodecError as error:
        return str(error)


def test_random_messages_of_all_types_have_the_bytes_of_the_walker() -> None:
    walked = []
    for name in TYPES:
        message = message_of(name)
        walker = Walker(type(message))
        data = walker.encode(message)

        def walk(data: bytes, walker: Walker[Any] = walker, name: str = name) -> Any:
            walked.append(name)
            return walker.decode(data)

        assert generated_codec.encoder(type(message), fail)(message) == data, name
        assert generated_codec.decoder(type(message), walk)(data) == message, name
        assert walker.decode(data) == message, name
    # The walker reads a time with very few nanoseconds at the end of a message.
    assert len(walked) < len(TYPES) / 20, walked


@pytest.mark.parametrize("message", USUAL, ids=lambda message: type(message).__name__)
def test_usual_messages_need_no_walker(message: Any) -> None:
    encode, decode = fast(type(message))
    data = encode(message)
    assert data == Walker(type(message)).encode(message)
    # NaN is not equal to itself, so the bytes are compared.
    assert encode(decode(data)) == data


@pytest.mark.parametrize(
    ("message_class", "value"),
    [
        (Float64, {"data": 3}),
        (Float64, {"data": 3.0, "more": 1}),
        (Float64, {}),
        (PoseStamped, {"pose": {"position": {"x": 1.0}}, "header": {"frame_id": "map"}}),
        (JointState, {"name": ["a"], "position": [1.0]}),
        (UInt8, {"data": 256}),
        (Float32, {"data": 1e300}),
        (Time, {"sec": 2**31, "nanosec": 70_000}),
        (Time, {"sec": 70_000, "nanosec": -1}),
        (String, {"data": 5}),
    ],
)
def test_bytes_of_others_are_read_by_the_walker(message_class: Any, value: Any) -> None:
    codec, data = messagepack_codec_for(message_class), packb(value)
    assert outcome(codec.decode, data) == outcome(Walker(message_class).decode, data)


def test_a_dataclass_has_the_bytes_and_errors_of_the_walker() -> None:
    reading: Any = Reading
    usual: dict[str, Any] = {
        "name": "a", "count": 2, "ratio": 0.5, "is_valid": True, "blob": b"", "values": [1.0],
        "counts": [1], "texts": ["x"], "pairs": [],
    }  # fmt: skip
    for field, value in (
        ("ratio", 1), ("ratio", True), ("is_valid", 1), ("blob", [1, 2]), ("values", (1, 2.0)),
        ("values", [True]), ("counts", [2**63]), ("counts", [1.0]), ("texts", ["a", 1]),
        ("pairs", [Pair(1), None]), ("count", 2**63),
    ):  # fmt: skip
        message = reading(**(usual | {field: value}))
        assert sent(messagepack_codec_for(Reading).encode, message) == sent(
            Walker(Reading).encode, message
        )


def made(name: str, text: str) -> Any:
    """Return the class of a definition that exists only in these tests."""
    register_spec(parse_message(f"codec_tests/msg/{name}", text))
    return get_message(f"codec_tests/msg/{name}")


def test_a_text_or_list_above_its_bound_is_refused() -> None:
    bounds = made(
        "Bounds",
        "string<=3 name\nint32[<=2] ids\nbyte[<=2] octets\nstring<=3[<=2] names\nbool[<=2] flags\n",
    )
    loose = made("Loose", "string name\nint32[] ids\nbyte[] octets\nstring[] names\nbool[] flags\n")
    usual = {"name": "abc", "ids": [1, 2], "octets": [b"a"], "names": ["abc"], "flags": [True]}
    encode, decode = fast(bounds)
    assert decode(encode(bounds(**usual))) == bounds(**usual)
    for field, value in (
        ("name", "abcd"), ("ids", [1, 2, 3]), ("octets", [b"a"] * 3), ("names", ["abcd"]),
        ("names", ["a"] * 3), ("flags", [True] * 3),
    ):  # fmt: skip
        message, wrong = bounds(), loose(**(usual | {field: value}))
        setattr(message, f"_{field}", getattr(wrong, field))
        with pytest.raises(CodecError, match=field):
            messagepack_codec_for(bounds).encode(message)
        with pytest.raises(CodecError, match=field):
            messagepack_codec_for(bounds).decode(messagepack_codec_for(loose).encode(wrong))


def test_values_that_were_not_checked_are_refused() -> None:
    for message, slot, value in (
        (Float64(), "_data", "1"),
        (UInt8(), "_data", 256),
        (UInt8(), "_data", 1.0),
        (Float32(), "_data", 1e39),
        (String(), "_data", b"x"),
        (PoseStamped(), "_header", None),
        (JointState(), "_name", ["a", 1]),
        (TFMessage(), "_transforms", (5,)),
    ):
        setattr(message, slot, value)
        with pytest.raises(CodecError, match=slot[1:]):
            messagepack_codec_for(type(message)).encode(message)


class Shout(String):
    def loud(self) -> str:
        return self.data.upper()


def test_a_subclass_is_decoded_as_itself() -> None:
    codec = messagepack_codec_for(Shout)
    assert codec.decode(codec.encode(Shout(data="hi"))).loud() == "HI"


def test_dataclasses_inside_messages_keep_their_values() -> None:
    name = message_spec_of(Pair).name
    register_spec(parse_message("codec_tests/msg/HoldsPair", f"{name} pair\n"))
    holder: Any = get_message("codec_tests/msg/HoldsPair")
    codec = messagepack_codec_for(holder)
    assert codec.decode(codec.encode(holder(pair=Pair(41)))).pair == Pair(41)


def test_a_list_that_another_thread_changes_is_encoded_whole() -> None:
    message, is_over = TFMessage(transforms=[TransformStamped()]), threading.Event()

    def change() -> None:
        while not is_over.is_set():
            message.transforms.append(TransformStamped())
            message.transforms.pop()

    thread, interval = threading.Thread(target=change), sys.getswitchinterval()
    codec = messagepack_codec_for(TFMessage)
    sys.setswitchinterval(1e-6)
    thread.start()
    try:
        for _ in range(2000):
            assert len(codec.decode(codec.encode(message)).transforms) in {1, 2}
    finally:
        is_over.set()
        thread.join()
        sys.setswitchinterval(interval)


@given(
    name=st.sampled_from(TYPES),
    seed=st.integers(min_value=0, max_value=1000),
    edits=st.lists(st.tuples(st.floats(0, 1), st.integers(0, 255)), max_size=4),
    cut=st.floats(0.5, 1.5),
)
def test_damaged_messages_have_the_outcome_of_the_walker(
    name: str, seed: int, edits: list[tuple[float, int]], cut: float
) -> None:
    message = random_message(get_interface(name), Random(seed))
    codec = messagepack_codec_for(type(message))
    data = bytearray(codec.encode(message))
    for where, byte in edits:
        data[int(where * (len(data) - 1))] = byte
    damaged = bytes(data[: int(cut * len(data))])
    assert outcome(codec.decode_strictly, damaged) == outcome(Walker(type(message)).decode, damaged)
