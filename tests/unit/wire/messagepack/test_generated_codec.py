"""Tests of the fast encoders and decoders: they do the same as the careful ones."""

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

import zbot  # noqa: F401 - makes the messages importable
from tests.unit.wire.messagepack.coded import packb
from tests.unit.wire.random_message import random_message, shipped_messages
from zbot.interfaces import get_interface, get_message, message_spec_of, register_spec
from zbot.interfaces.parser import parse_message
from zbot.wire.errors import CodecError
from zbot.wire.messagepack import generated_codec
from zbot.wire.messagepack.codec import codec_for

from builtin_interfaces.msg import Time
from geometry_msgs.msg import PoseStamped, TransformStamped
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import Image, Imu, JointState, LaserScan
from std_msgs.msg import Byte, Float32, Float64, Header, Int64, String, UInt8
from tf2_msgs.msg import TFMessage

SUPPORTED = [
    name for name in shipped_messages() if generated_codec.is_supported(get_interface(name))
]
NOW = Header(stamp=Time(sec=1_700_000_000, nanosec=999_999_999), frame_id="odom")
USUAL = [
    Imu(header=NOW),
    JointState(header=NOW, name=["a", "b" * 40], position=[1.0, 2.0]),
    Clock(clock=Time(sec=60_000, nanosec=500_000_000)),
    LaserScan(header=NOW, ranges=[1.0] * 2000, range_max=math.inf, angle_min=math.nan),
    Image(header=NOW, encoding="rgb8", data=bytes(70_000)),
    TFMessage(transforms=[TransformStamped(header=NOW)] * 20),
    Header(),
    String(data="x" * 100_000),
    Int64(data=-(2**63)),
    Byte(data=b"\xff"),
]


def fail(_: Any) -> Any:
    pytest.fail("the careful function was called")


def fast(message_class: type[Any]) -> tuple[Any, Any]:
    return generated_codec.encoder(message_class, fail), generated_codec.decoder(
        message_class, fail
    )


def outcome(decode: Any, data: bytes) -> Any:
    try:
        return codec_for(type(message := decode(data))).encode_carefully(message)
    except CodecError as error:
        return str(error)


def test_most_types_are_supported() -> None:
    assert len(SUPPORTED) > 1000


def test_random_messages_of_all_types_have_the_careful_bytes() -> None:
    for name in SUPPORTED:
        message = random_message(get_interface(name), Random(name))
        codec = codec_for(type(message))
        data = codec.encode_carefully(message)
        assert codec.encode(message) == data, name
        assert codec.decode(data) == codec.decode_carefully(data) == message, name


@pytest.mark.parametrize("message", USUAL, ids=lambda one: type(one).__name__)
def test_usual_messages_need_no_careful_function(message: Any) -> None:
    encode, decode = fast(type(message))
    data = encode(message)
    assert data == codec_for(type(message)).encode_carefully(message)
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
def test_bytes_of_others_are_read_carefully(message_class: Any, value: Any) -> None:
    codec, data = codec_for(message_class), packb(value)
    assert outcome(codec.decode, data) == outcome(codec.decode_carefully, data)


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
            codec_for(type(message)).encode(message)


class Shout(String):
    def loud(self) -> str:
        return self.data.upper()


def test_a_subclass_is_decoded_as_itself() -> None:
    codec = codec_for(Shout)
    assert codec.decode(codec.encode(Shout(data="hi"))).loud() == "HI"


@dataclass
class Pair:
    a: int = 0


def test_dataclasses_inside_messages_keep_their_values() -> None:
    name = message_spec_of(Pair).name
    register_spec(parse_message("codec_tests/msg/HoldsPair", f"{name} pair\n"))
    holder: Any = get_message("codec_tests/msg/HoldsPair")
    codec = codec_for(holder)
    assert codec.decode(codec.encode(holder(pair=Pair(41)))).pair == Pair(41)


def test_a_list_that_another_thread_changes_is_encoded_whole() -> None:
    message, is_over = TFMessage(transforms=[TransformStamped()]), threading.Event()

    def change() -> None:
        while not is_over.is_set():
            message.transforms.append(TransformStamped())
            message.transforms.pop()

    thread, interval = threading.Thread(target=change), sys.getswitchinterval()
    codec = codec_for(TFMessage)
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
    name=st.sampled_from(SUPPORTED),
    seed=st.integers(min_value=0, max_value=1000),
    edits=st.lists(st.tuples(st.floats(0, 1), st.integers(0, 255)), max_size=4),
    cut=st.floats(0.5, 1.5),
)
def test_damaged_messages_have_the_careful_outcome(
    name: str, seed: int, edits: list[tuple[float, int]], cut: float
) -> None:
    message = random_message(get_interface(name), Random(seed))
    codec = codec_for(type(message))
    data = bytearray(codec.encode(message))
    for where, byte in edits:
        data[int(where * (len(data) - 1))] = byte
    damaged = bytes(data[: int(cut * len(data))])
    assert outcome(codec.decode_strictly, damaged) == outcome(codec.decode_carefully, damaged)
